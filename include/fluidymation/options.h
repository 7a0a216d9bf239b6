#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/io/compression_level.h"

namespace fluidymation {

/// One numbered image sequence: frame i is number start + i * speed (thesis §4.5).
struct SequenceOptions {
  std::string path;    ///< printf pattern with exactly one integer conversion
  int start = 1;       ///< number of the first frame
  int frames = 50;     ///< frames at most, >= 1; the sequence may end earlier
  int speed = 1;       ///< index increment between frames, not 0; negative plays backwards
  double scale = 1.0;  ///< scaling of the input frames, > 0
  /// Whether `frames` is their number, not just an upper bound: missing ones at the end are a
  /// fault.
  bool complete = false;
};

struct MaskOptions {
  float blurSigmaPx = 8.0F;  ///< Gaussian smoothing of the mask, >= 0; 0 switches it off; §4.1
  float threshold = 0.3F;    ///< in (0, 0.5]; below 0.5 some bare surface is included; §4.1
};

/// What the border of a shape tells about the movement inside; §3.8.
enum class MotionModel {
  kNormals,     ///< the thesis': the movement along the normals, spread harmonically
  kRigidParts,  ///< each part's translation, rotation and scaling; only the rest is spread
};

struct GuideOptions {
  MaskOptions mask;
  float timeBlurSigmaFrames = 2.0F;  ///< temporal smoothing of the distance field, 0 to 50; §4.1
  /// Temporal smoothing of the flow, 0 to 50; the paper's way instead of the above, with 1.5; P
  /// App. A. See `FlowAverages`.
  float flowBlurSigmaFrames = 0.0F;
  MotionModel motionModel = MotionModel::kNormals;
  std::optional<float> shapeBlurRadiusPx;  ///< of the guide of ShapeGuide::kBlurredMask, if wanted
};

/// What the bounds of the temporal modulation are multiples of.
enum class ModulationUnit {
  kPixels,
  kBorderWidths,
  kTargetSides,  ///< the larger side of the target's frames, the paper's d
};

/// Distance bounds of the temporal modulation; §3.7, P§3.4. These are those of the thesis, which go
/// with a border of 10 px.
struct ModulationBounds {
  float upper = 1.0F;  ///< m_u: from here on the previous frame does not count
  float lower = 0.2F;  ///< m_l: up to here it counts in full
  ModulationUnit unit = ModulationUnit::kBorderWidths;
};

/// What tells a shape's edge from its inside.
enum class ShapeGuide {
  kEdgeDistance,  ///< the thesis': distance to the edge, up to the border width; §3.4
  kBlurredMask,   ///< the paper's: Gaussian of the mask with the border width as radius; P§3.1
};

/// Which distances to the edge the temporal modulation compares.
enum class ModulationDistance {
  kClamped,    ///< up to the border width: deep inside all is alike
  kUnclamped,  ///< as the documents print it; §3.7, P§3.4
};

/// What shapes decide about a match besides colours. Defaults: the thesis.
struct ShapeRules {
  ShapeGuide guide = ShapeGuide::kEdgeDistance;
  bool hardSegments = true;  ///< whether a match stays in its segment, border or interior; §3.4
  ModulationDistance modulation = ModulationDistance::kClamped;
};

/// How a picture is read from the exemplar between its pixels.
enum class Interpolation {
  kBilinear,  ///< the thesis'; softens whatever is not turned by a multiple of 90 degrees
  kCubic,     ///< Catmull-Rom, 4 x 4 pixels
  kLanczos,   ///< Lanczos' windowed sinc, 6 x 6 pixels: keeps fine detail best
};

/// How the windows that cover a pixel of the painted picture are averaged; §2.1.2. The thesis takes
/// their plain bilinear mean.
struct VoteOptions {
  /// Gaussian weight of a window by the distance of its centre along x and y, px; 0: all alike.
  float sigmaPx = 0.35F;
  Interpolation interpolation = Interpolation::kLanczos;
  /// Gaussian weight of a window by how much deeper in its shape the exemplar's pixel lies than the
  /// painted one, px, as far as the border goes; 0: all alike, as in the thesis. A patch that fits
  /// else may reach past the rim of its own shape, and its bare pixels would show inside.
  float depthSigmaPx = 0.5F;
  /// How much the steps from pixel to pixel that windows show count beside the colours, where the
  /// windows of neighbouring pixels do not continue each other; 0: not at all, as in the thesis.
  /// Seams between pieces of the exemplar become slopes of about the root of this in px, and what
  /// lies within the pieces keeps its detail (docs/decisions.md).
  float seamWeight = 0.3F;
};

/// In what units the motion extents of exemplar and target are compared; §3.5.
enum class ExtentUnit {
  kPixels,    ///< the thesis': what moves further than the exemplar is pulled to its extremes
  kExemplar,  ///< relative to the exemplar's own mean extent, and bounded
};

/// How parts of the target that are thinner than the medium's rim are painted; §3.4.
enum class ThinParts {
  kFringe,  ///< the thesis': by the distance to the edge, which stays small
  kBody,    ///< by the distance relative to the part's own thickness
};

/// What happens on the finest level; coarser ones are always searched.
enum class FinestLevel {
  kUpscaled,  ///< the thesis': matches of the next coarser level, enlarged; §4.4.3
  kRefined,   ///< of these and the previous frame's full-resolution matches the better ones, then
              ///< one sweep that tries those of their neighbours
  kSearched,  ///< likewise, and the sweep searches at random too: calmest, and half as fast
};

/// Which frames a frame is to be coherent with; §3.7, P§5.
enum class TemporalCoherence {
  kForward,        ///< the thesis': with the one before
  kBidirectional,  ///< with the one after, too: calmer where shapes shrink, at twice the time
};

/// Where the search spends its effort; §2.2, §4.3.
enum class SearchEffort {
  kEverywhere,      ///< the thesis': every sweep tries two neighbours' matches and random ones
                    ///< everywhere
  kWhereItChanges,  ///< random matches where the last sweep has changed something, with them the
                    ///< matches of four neighbours, all where they are new: half the work for
                    ///< matches about as good
};

struct SynthesisOptions {
  float texWeight = 1.0F;   ///< colours of the picture as it stands; §3.7, P§3.1
  float distWeight = 5.0F;  ///< edge or shape guide; §3.4, P§3.1
  float flowWeight = 0.1F;  ///< motion extent guides; §3.5
  float dirWeight = 0.0F;   ///< directions of movement within a window; §3.6, P§3.2
  float prevWeight = 1.0F;  ///< temporal coherence; §3.7
  /// How many times over, while the target moves by a border width, the previous frame's colours
  /// change as the film's do from one distance to the edge to another, see `setPrevious`, at most
  /// by the whole change in a frame; 0: not at all, as in the thesis. More keeps body colours
  /// better and fronts less steady (docs/quality.md). Of no account where ages are compared: there
  /// the film's own time says what becomes of a rim.
  float prevDeepening = 1.0F;
  /// Frames of the exemplar by which a match of the previous frame may be moved on, forwards or
  /// backwards, to lie as deep inside the mask as its pixel, see `fitDepths`; 0: none, as in the
  /// thesis. Of no account where ages are compared.
  int prevDepthReachFrames = 20;
  /// How much of the drift of colours is undone in each frame where the target moves: of the mean
  /// difference, at each distance to the edge, between what is remembered of the previous frame and
  /// the film, see `setPrevious`; in [0, 1]; 0: nothing, as in the thesis. Of no account where ages
  /// are compared.
  float prevColorCorrection = 0.5F;
  /// What a match costs none of whose neighbours continues the same patch of the exemplar, in
  /// squares of a colour difference: large structures survive as larger pieces (docs/quality.md).
  /// Coherence in the sense of Hertzmann et al., Image Analogies (2001); the thesis has none.
  float coherenceWeight = 8.0F;
  float lambda = 2.0F;            ///< spatial uniformity; §2.5, §3.3
  int occRadiusFrames = 10;       ///< neighbouring frames that count as used; §3.3
  float patchmatchAlpha = 0.75F;  ///< shrink of the search box per candidate, (0, 0.99]; §4.3
  /// What `distWeight` is multiplied by, a channel scale. More than the thesis preset's 1 keeps the
  /// film's colours at the rim (docs/quality.md).
  float edgeGain = 4.0F;
  /// What `prevWeight` is multiplied by, a channel scale. More than the thesis preset's 1 makes
  /// fronts move more with the material, and costs little colour where `prevColorCorrection` keeps
  /// it (docs/quality.md).
  float prevGain = 2.0F;
  ShapeRules shape;
  ModulationBounds prevModulation;
  ThinParts thinParts = ThinParts::kBody;
  /// Whether movement that is too small for a step to another frame of the exemplar is kept for
  /// later; in the thesis it is lost, and targets slower than half the exemplar's speed freeze.
  bool carriesMotion = true;
  ExtentUnit extentUnit = ExtentUnit::kExemplar;
  /// What stays keeps its matches to the pixel, where enlarging draws them anew in blocks of 2x2 in
  /// every frame: the surface stays put, fronts move with the material (docs/quality.md).
  FinestLevel finestLevel = FinestLevel::kRefined;
  /// Of the votes within the optimization: Gaussian weight of a window by the distance of its
  /// centre, px; 0: all 25 alike, as in the thesis. A mean of 25 windows is smooth, and finds
  /// smooth patches. Of no account where ages are compared: what is new would look older.
  float optVoteSigmaPx = 0.5F;
  VoteOptions paintedVote;
  /// How much, at most, of a pixel whose match has changed is what it showed in the frame before,
  /// moved on as the film does, see `blendChanges`; in [0, 1]; 0: nothing, as in the thesis.
  float changeBlending = 0.4F;
  /// How far the finest detail of what is painted is brought to the film's own energy, see
  /// `restoreDetail`; in [0, 1]; 0: not at all, as in the thesis.
  float detailRestoration = 1.0F;
  /// Iterations per level, coarsest first, the last value repeats. Defaults of §4.5 (the table of
  /// §4.4.3 has 4, 2, 1 for the optimization).
  std::vector<int> patchmatchIterations = {6, 4};
  std::vector<int> optIterations = {4, 3, 2};
  SearchEffort searchEffort = SearchEffort::kWhereItChanges;
  TemporalCoherence temporalCoherence = TemporalCoherence::kForward;
  std::uint64_t seed = 0;
};

/// What a flow file of frame n says.
enum class FlowConvention {
  kBackward,  ///< the movement from frame n - 1 to n, seen on n
  kForward,   ///< the movement from frame n to n + 1, seen on n
};

/// What new material of the target looks like; P§5, thesis figure 5.4.
enum class NewMaterial {
  kAutomatic,  ///< kFresh where the target turns out to be lines being drawn, see `DrawnLines`
  kFresh,      ///< as in the film's first frames, and then ages as the film does
  kPlain,  ///< the thesis': as its motion extents say; what lies still looks as if it always had
};

/// Whether frames are painted from the last to the first; P§5, thesis figure 5.4.
enum class Reverse {
  kOff,
  kOn,
  kAutomatic,  ///< where new material is plain and the target turns out to be lines being drawn
};

/// Frames of a target by their own numbers, both ends included.
struct FrameNumbers {
  int first = 0;
  int last = 0;
};

/// What happens to files that have names of frames to be painted.
enum class ExistingFrames {
  kOwn,      ///< those that a run has painted are replaced; others are a fault
  kReplace,  ///< all are replaced
  kKeep,     ///< all are kept, and the frames count as painted
};

/// How a run goes on after one that was stopped, and what it keeps for the next one. None of this
/// changes a byte of a frame, unless `render` begins where no state is.
struct ContinuationOptions {
  bool resume = false;   ///< go on after the last frame that a state is there of
  bool restart = false;  ///< discard what a run that was stopped has left; not with `resume`
  /// A state is saved after every so many frames; where not given, as often as costs
  /// `kCheckpointShare` of the run.
  std::optional<int> checkpointEvery;
  bool keepStates = false;  ///< keep all of them, for `render`
  ExistingFrames existing = ExistingFrames::kOwn;
  std::optional<FrameNumbers> render;  ///< the only frames to be painted
  /// What to do about frames that must not be replaced, for messages: "wanted " and this.
  std::string waysOut =
      "--overwrite to replace, --skip-existing to keep what is there, or another --out-path";
};

/// Bits of a channel of the painted frames.
enum class BitDepth { k8, k16 };

/// Where the border width comes from when none is given.
enum class BorderWidthRule {
  kBySize,    ///< a share of the film's size: `automaticBorderWidthPx`
  kMeasured,  ///< where the film's colours stop depending on the distance to the edge
};

/// Everything one run depends on. What each option accepts is stated in option_ranges.h.
struct Options {
  SequenceOptions source;
  std::string sourceMaskPath;  ///< numbered and scaled as `source`
  /// Frames of `source` that are held at a time, P§5; not 1; 0, or more than there are: all.
  int sourceWindowFrames = 0;
  SequenceOptions target;
  std::string outPath;  ///< printf pattern; numbered as `target`

  /// Flow that replaces the one derived from the masks (P§3); numbered and scaled as `source` or
  /// `target`, whose speed has to be 1 or -1.
  std::optional<std::string> sourceFlowPath;
  std::optional<std::string> targetFlowPath;
  FlowConvention flowConvention = FlowConvention::kBackward;

  /// Smoothing of the exemplar's masks; where not given, it follows from their areas
  /// (`automaticBlurSigmaPx`).
  std::optional<float> blurSigmaPx;
  /// The same for the target; where not given, `blurSigmaPx`, else from the areas of its own masks.
  std::optional<float> targetBlurSigmaPx;
  float maskThreshold = 0.3F;  ///< of both, in (0, 0.5]; §4.1
  /// Border segment: distance below this, §3.4; where not given, it is found by `borderWidthRule`.
  std::optional<float> borderWidthPx;
  BorderWidthRule borderWidthRule = BorderWidthRule::kBySize;
  float timeBlurSigmaFrames = 2.0F;
  float flowBlurSigmaFrames = 0.0F;
  /// Of the target. A filmed medium spreads by its edge and does not travel as a whole.
  MotionModel motionModel = MotionModel::kNormals;
  NewMaterial newMaterial = NewMaterial::kAutomatic;
  /// The order that frames are painted in; numbers and names are the same in either. Material is
  /// plain then.
  Reverse reverse = Reverse::kOff;
  SynthesisOptions synthesis;
  /// Whose hue and chroma the painted medium gets, pixel by pixel as much of it as there is
  /// (`Recoloring`); lightness stays.
  std::optional<Rgb8> recolor;

  std::optional<std::string> dumpGuidesDirectory;
  ContinuationOptions continuation;
  int compressionLevel = kDefaultCompression;  ///< of the painted frames: size and clock only
  BitDepth bitDepth = BitDepth::k8;            ///< likewise
  /// What the frames are laid over, which makes them opaque: a colour ("#F4F1E8", "#fff", "white",
  /// "black", "gray"), a PNG file, or the film's bare surface ("exemplar"). None: straight alpha.
  std::optional<std::string> background;
  int threads = 1;  ///< changes the clock only, never a byte
  /// What the run may need, at least `ranges::kLeastMemoryBytes`; none: what the machine has.
  std::optional<std::int64_t> maxMemoryBytes;
};

}  // namespace fluidymation

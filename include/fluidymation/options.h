#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fluidymation {

/// One numbered image sequence: frame i is number start + i * speed (thesis §4.5).
struct SequenceOptions {
  std::string path;    ///< printf pattern with exactly one integer conversion
  int start = 1;       ///< number of the first frame
  int frames = 50;     ///< frames at most, >= 1; the sequence may end earlier
  int speed = 1;       ///< index increment between frames, not 0; negative plays backwards
  double scale = 1.0;  ///< scaling of the input frames, > 0
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
  MotionModel motionModel = MotionModel::kNormals;
};

/// Distance bounds of the temporal modulation, px; §3.7.
struct ModulationBounds {
  float upperPx = 10.0F;  ///< m_u: from here on the previous frame does not count
  float lowerPx = 2.0F;   ///< m_l: up to here it counts in full
};

/// The bounds of the temporal modulation that suit most, as shares of the border width. The thesis'
/// (1 and 0.2) let a rim keep colours of a depth that it has left: the edge colour profile is half
/// a dE worse (docs/quality.md).
struct ModulationShares {
  float upper = 0.7F;
  float lower = 0.15F;
};
inline constexpr ModulationShares kModulationShares;

/// How a picture is read from the exemplar between its pixels.
enum class Interpolation {
  kBilinear,  ///< the thesis'; softens whatever is not turned by a multiple of 90 degrees
  kCubic,     ///< Catmull-Rom, 4 x 4 pixels
};

/// How the windows that cover a pixel of the painted picture are averaged; §2.1.2. The votes within
/// the optimization are plain bilinear means always, and so is this one in the thesis.
struct VoteOptions {
  /// Gaussian weight of a window by the distance of its centre along x and y, px; 0: all alike.
  float sigmaPx = 0.5F;
  Interpolation interpolation = Interpolation::kCubic;
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

struct SynthesisOptions {
  float distWeight = 5.0F;        ///< edge guide; §3.4
  float flowWeight = 0.1F;        ///< motion extent guides; §3.5
  float prevWeight = 1.0F;        ///< temporal coherence; §3.7
  float lambda = 2.0F;            ///< spatial uniformity; §2.5, §3.3
  int occRadiusFrames = 10;       ///< neighbouring frames that count as used; §3.3
  float patchmatchAlpha = 0.75F;  ///< shrink of the search box per candidate, (0, 0.99]; §4.3
  /// What `distWeight` is multiplied by, a channel scale. Twice the thesis preset's brings the edge
  /// colour profile from 4.7 to 4.1 dE (docs/quality.md).
  float edgeGain = 2.0F;
  /// Where not given, kModulationShares of the border width.
  std::optional<ModulationBounds> prevModulation;
  ThinParts thinParts = ThinParts::kBody;
  /// Whether movement that is too small for a step to another frame of the exemplar is kept for
  /// later; in the thesis it is lost, and targets slower than half the exemplar's speed freeze.
  bool carriesMotion = true;
  ExtentUnit extentUnit = ExtentUnit::kExemplar;
  VoteOptions paintedVote;
  /// Iterations per level, coarsest first, the last value repeats. Defaults of §4.5 (the table of
  /// §4.4.3 has 4, 2, 1 for the optimization).
  std::vector<int> patchmatchIterations = {6, 4};
  std::vector<int> optIterations = {4, 3, 2};
  std::uint64_t seed = 0;
};

/// Everything one run depends on. What each option accepts is stated in option_ranges.h.
struct Options {
  SequenceOptions source;
  std::string sourceMaskPath;  ///< numbered and scaled as `source`
  SequenceOptions target;
  std::string outPath;  ///< printf pattern; numbered as `target`

  /// Smoothing of the exemplar's masks; where not given, it follows from their areas
  /// (`automaticBlurSigmaPx`).
  std::optional<float> blurSigmaPx;
  /// The same for the target; where not given, `blurSigmaPx`, else from the areas of its own masks.
  std::optional<float> targetBlurSigmaPx;
  float maskThreshold = 0.3F;  ///< of both, in (0, 0.5]; §4.1
  /// Border segment: distance below this, §3.4; where not given, it follows from the size of the
  /// exemplar (`automaticBorderWidthPx`).
  std::optional<float> borderWidthPx;
  float timeBlurSigmaFrames = 2.0F;
  /// Of the target. A filmed medium spreads by its edge and does not travel as a whole.
  MotionModel motionModel = MotionModel::kNormals;
  SynthesisOptions synthesis;

  std::optional<std::string> dumpGuidesDirectory;
  int threads = 1;  ///< changes the clock only, never a byte
};

}  // namespace fluidymation

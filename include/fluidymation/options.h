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

struct GuideOptions {
  MaskOptions mask;
  float timeBlurSigmaFrames = 2.0F;  ///< temporal smoothing of the distance field, 0 to 50; §4.1
};

/// Distance bounds of the temporal modulation, px; §3.7.
struct ModulationBounds {
  float upperPx = 10.0F;  ///< m_u: from here on the previous frame does not count
  float lowerPx = 2.0F;   ///< m_l: up to here it counts in full
};

struct SynthesisOptions {
  float distWeight = 5.0F;        ///< edge guide; §3.4
  float flowWeight = 0.1F;        ///< motion extent guides; §3.5
  float prevWeight = 1.0F;        ///< temporal coherence; §3.7
  float lambda = 2.0F;            ///< spatial uniformity; §2.5, §3.3
  int occRadiusFrames = 10;       ///< neighbouring frames that count as used; §3.3
  float patchmatchAlpha = 0.75F;  ///< shrink of the search box per candidate, (0, 0.99]; §4.3
  float borderWidthPx = 10.0F;    ///< border segment: distance below this; §3.4
  ModulationBounds prevModulation;
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

  MaskOptions sourceMask;
  std::optional<float> targetBlurSigmaPx;  ///< the source's where not given
  float timeBlurSigmaFrames = 2.0F;
  SynthesisOptions synthesis;

  std::optional<std::string> dumpGuidesDirectory;
  int threads = 1;  ///< changes the clock only, never a byte
};

}  // namespace fluidymation

#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fluidymation/core/image.h"
#include "fluidymation/io/png.h"
#include "support/process.h"
#include "support/temporary_folder.h"

namespace fluidymation::test {

/// Options of the tool by name; an empty value makes it a flag.
using ToolOptions = std::map<std::string, std::string>;

[[nodiscard]] std::vector<std::string> argumentsOf(const ToolOptions& options);

/// With --quiet.
[[nodiscard]] ToolOptions quietly(ToolOptions options);

/// A gray 8-bit PNG file, black and white.
[[nodiscard]] Bytes maskPng(const Mask& mask);

/// What the tool makes of a hard mask before it paints.
[[nodiscard]] Mask smoothed(const Mask& mask, float sigmaPx);

/// An RGB 8-bit PNG file.
[[nodiscard]] Bytes colorPng(const Image<Rgba8>& picture);

/// Coarse random colours inside, darker towards the edge, which is a round one of `radiusPx` about
/// the image's centre; paper outside.
[[nodiscard]] Image<Rgba8> texturedDisc(Size size, float radiusPx, std::uint64_t seed);

/// The input of one run, small enough for a run to take milliseconds, in a folder of its own:
/// src/00001.png, mask/00001.png and target/00001.png onwards. The exemplar is a textured disc that
/// grows, the target a disc that moves.
class SmallScene {
 public:
  explicit SmallScene(int frameCount = 4) : SmallScene(frameCount, {24, 20}, {28, 22}) {}
  SmallScene(int frameCount, Size source, Size target);

  [[nodiscard]] Mask sourceMask(int number) const;
  [[nodiscard]] Mask targetMask(int number) const;

  /// "target/00003.png"
  [[nodiscard]] static std::string frame(const std::string& sequence, int number);

  /// Absolute path of a file of the scene.
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }
  void write(const std::string& name, const Bytes& bytes) const;
  [[nodiscard]] Bytes read(const std::string& name) const { return readBytes(file(name)); }
  void remove(const std::string& name) const;

  /// Everything in a folder of the scene, hidden files too, sorted; empty when there is no such
  /// folder. Not what a run keeps beside its frames: manifest and hidden folder.
  [[nodiscard]] std::vector<std::string> names(const std::string& folder) const;

  /// Options that suit so small pictures, with paths relative to the scene's folder.
  [[nodiscard]] static ToolOptions defaults();

  /// Runs the tool in the scene's folder with the defaults, changed and completed by `options`.
  [[nodiscard]] ProcessResult paint(const ToolOptions& options = {}, ProcessSetup setup = {}) const;

  /// Runs the tool in the scene's folder with these options and no others.
  [[nodiscard]] ProcessResult paintWithoutDefaults(const ToolOptions& options,
                                                   ProcessSetup setup = {}) const;

  /// Runs it as an ordinary user, whom permissions hold back, and gives the scene to that user.
  [[nodiscard]] ProcessResult paintUnprivileged(const ToolOptions& options = {}) const;

  /// The same as `paint` with --quiet, and no reason to say anything: what was painted, by file
  /// name.
  using Painting = std::map<std::string, Bytes>;
  [[nodiscard]] Painting painting(const ToolOptions& options = {}) const;

 private:
  TemporaryFolder folder_;
  Size sourceSize_;
  Size targetSize_;
};

/// The names in an output folder: where nothing was painted, and where all four frames of the usual
/// scene were.
inline const std::vector<std::string> kNothing;
inline const std::vector<std::string> kFourFrames = {"00001.png", "00002.png", "00003.png",
                                                     "00004.png"};

/// All files of a folder by name, likewise without manifest and folders.
[[nodiscard]] SmallScene::Painting filesOf(const std::string& folder);

/// Whether this is an 8-bit RGBA file of the mask's size that is opaque inside the mask, and
/// transparent outside, and black away from it.
[[nodiscard]] ::testing::AssertionResult isPaintedExactly(const std::string& path,
                                                          const Mask& mask);

/// Whether the tool ended with this code and one line on standard error, "fluidymation: error: "
/// and `message`, and wrote nothing to standard output.
[[nodiscard]] ::testing::AssertionResult failedWith(int exitCode, const std::string& message,
                                                    const ProcessResult& result);

/// The same for a message that begins with `beginning` and contains all of `parts`.
[[nodiscard]] ::testing::AssertionResult failedNaming(int exitCode, const std::string& beginning,
                                                      const std::vector<std::string>& parts,
                                                      const ProcessResult& result);

}  // namespace fluidymation::test

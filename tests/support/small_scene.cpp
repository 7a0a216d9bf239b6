#include "support/small_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "fluidymation/core/random.h"
#include "fluidymation/guides/mask.h"
#include "support/png_maker.h"
#include "support/privileges.h"
#include "support/shapes.h"

namespace fluidymation::test {
namespace {

namespace fs = std::filesystem;

Vec2 centreOf(Size size) {
  return {0.5F * static_cast<float>(size.width - 1), 0.5F * static_cast<float>(size.height - 1)};
}

float shorterSide(Size size) { return static_cast<float>(std::min(size.width, size.height)); }

/// Grows from a quarter of the shorter side outwards, by 1.25 px a frame.
float sourceRadius(Size size, int number) {
  return 0.25F * shorterSide(size) + 1.25F * static_cast<float>(number - 1);
}

constexpr const char* kErrorPrefix = "fluidymation: error: ";

/// What a run keeps beside its frames.
bool isKeptBeside(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  constexpr std::string_view kManifest = "fluidymation.json";
  return name == ".fluidymation" ||
         (name.size() >= kManifest.size() &&
          name.compare(name.size() - kManifest.size(), kManifest.size(), kManifest) == 0);
}

::testing::AssertionResult describe(const char* what, const ProcessResult& result) {
  return ::testing::AssertionFailure()
         << what << "; exit code " << result.exitCode << ", signal " << result.signal
         << (result.timedOut ? ", timed out" : "") << "\nstandard error:\n"
         << result.err << "standard output:\n"
         << result.out;
}

}  // namespace

std::vector<std::string> argumentsOf(const ToolOptions& options) {
  std::vector<std::string> arguments;
  for (const auto& [name, value] : options) {
    arguments.push_back(name);
    if (!value.empty()) arguments.push_back(value);
  }
  return arguments;
}

ToolOptions quietly(ToolOptions options) {
  options["--quiet"] = "";
  return options;
}

Bytes maskPng(const Mask& mask) {
  PngSpec spec;
  spec.size = mask.size();
  for (const std::uint8_t inside : mask) spec.samples.push_back(inside != 0 ? 255 : 0);
  return makePng(spec);
}

Mask smoothed(const Mask& mask, float sigmaPx) {
  MaskOptions options;
  options.blurSigmaPx = sigmaPx;
  return smoothMask(mask, options);
}

Bytes colorPng(const Image<Rgba8>& picture) {
  PngSpec spec;
  spec.size = picture.size();
  spec.color = PngColor::kRgb;
  for (const Rgba8& pixel : picture) {
    for (const std::uint8_t channel : {pixel.r, pixel.g, pixel.b}) spec.samples.push_back(channel);
  }
  return makePng(spec);
}

Image<Rgba8> texturedDisc(Size size, float radiusPx, std::uint64_t seed) {
  constexpr int kCellPx = 2;
  constexpr float kRimPx = 3.0F;
  Image<Rgba8> picture(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Vec2 here{static_cast<float>(x), static_cast<float>(y)};
      const float depth = radiusPx - length(here - centreOf(size));
      if (depth <= 0.0F) {
        picture(x, y) = {240, 236, 225, 255};
        continue;
      }
      Random random({seed, 0, 0, 0, x / kCellPx, y / kCellPx});
      const float shade = std::min(1.0F, 0.4F + 0.6F * depth / kRimPx);
      const auto channel = [&](int low, int high) {
        return static_cast<std::uint8_t>(shade * static_cast<float>(random.uniform(low, high)));
      };
      const std::uint8_t red = channel(120, 220);
      const std::uint8_t green = channel(60, 150);
      picture(x, y) = {red, green, channel(90, 250), 255};
    }
  }
  return picture;
}

SmallScene::SmallScene(int frameCount, Size source, Size target)
    : sourceSize_(source), targetSize_(target) {
  constexpr std::uint64_t kGrainSeed = 11;
  for (int number = 1; number <= frameCount; ++number) {
    write(frame("src", number),
          colorPng(texturedDisc(source, sourceRadius(source, number), kGrainSeed)));
    write(frame("mask", number), maskPng(sourceMask(number)));
    write(frame("target", number), maskPng(targetMask(number)));
  }
}

Mask SmallScene::sourceMask(int number) const {
  return disc(sourceSize_, centreOf(sourceSize_), sourceRadius(sourceSize_, number));
}

Mask SmallScene::targetMask(int number) const {
  Vec2 centre = centreOf(targetSize_);
  centre.x += 1.5F * static_cast<float>(number - 1) - 3.0F;
  return disc(targetSize_, centre, 0.3F * shorterSide(targetSize_));
}

std::string SmallScene::frame(const std::string& sequence, int number) {
  const std::string digits = std::to_string(number);
  return sequence + "/" + std::string(5 - std::min<std::size_t>(digits.size(), 5), '0') + digits +
         ".png";
}

void SmallScene::write(const std::string& name, const Bytes& bytes) const {
  fs::create_directories(fs::path(file(name)).parent_path());
  writeBytes(file(name), bytes);
}

void SmallScene::remove(const std::string& name) const { fs::remove_all(file(name)); }

std::vector<std::string> SmallScene::names(const std::string& folder) const {
  std::vector<std::string> names;
  if (!fs::is_directory(file(folder))) return names;
  for (const auto& entry : fs::directory_iterator(file(folder))) {
    if (!isKeptBeside(entry)) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

ToolOptions SmallScene::defaults() {
  return {{"--src-path", "src/%05d.png"},
          {"--src-mask-path", "mask/%05d.png"},
          {"--target-path", "target/%05d.png"},
          {"--out-path", "out/%05d.png"},
          {"--blur-sigma", "1"},
          {"--time-blur-sigma", "1"},
          {"--border-width", "3"},
          {"--prev-modulation-bounds", "6,1"},
          {"--threads", "1"}};  // tests run side by side
}

ProcessResult SmallScene::paint(const ToolOptions& options, ProcessSetup setup) const {
  ToolOptions all = options;
  const ToolOptions standard = defaults();
  all.insert(standard.begin(), standard.end());  // what is given already stays
  return paintWithoutDefaults(all, std::move(setup));
}

ProcessResult SmallScene::paintWithoutDefaults(const ToolOptions& options,
                                               ProcessSetup setup) const {
  setup.workingFolder = folder_.path();
  return runProcess(FLUIDYMATION_PROGRAM, argumentsOf(options), setup);
}

ProcessResult SmallScene::paintUnprivileged(const ToolOptions& options) const {
  giveAway(folder_.path());
  ProcessSetup setup;
  setup.unprivileged = true;
  return paint(options, setup);
}

SmallScene::Painting SmallScene::painting(const ToolOptions& options) const {
  remove("out");
  const ProcessResult result = paint(quietly(options));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, "");
  return filesOf(file("out"));
}

SmallScene::Painting filesOf(const std::string& folder) {
  SmallScene::Painting files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (isKeptBeside(entry) || entry.is_directory()) continue;
    files[entry.path().filename().string()] = readBytes(entry.path().string());
  }
  return files;
}

::testing::AssertionResult isPaintedExactly(const std::string& path, const Mask& mask) {
  const Bytes bytes = readBytes(path);
  if (bytes.empty()) return ::testing::AssertionFailure() << path << " is missing or empty";
  const Bytes header = splitPng(bytes).front().data;
  if (header.at(8) != 8 || header.at(9) != 6) {
    return ::testing::AssertionFailure() << path << " is not of 8-bit RGBA";
  }
  const Image<Rgba> picture = readPng(path);
  if (picture.size() != mask.size()) {
    return ::testing::AssertionFailure()
           << path << " is " << picture.width() << "x" << picture.height() << ", wanted "
           << mask.width() << "x" << mask.height();
  }
  // Beside the paint, transparent pixels have its colours; further out they have none.
  constexpr int kColorMarginPx = 4;
  const auto isNearPaint = [&](int x, int y) {
    for (int ny = y - kColorMarginPx; ny <= y + kColorMarginPx; ++ny) {
      for (int nx = x - kColorMarginPx; nx <= x + kColorMarginPx; ++nx) {
        if (mask.contains(nx, ny) && mask(nx, ny) != 0) return true;
      }
    }
    return false;
  };
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      const Rgba& p = picture(x, y);
      const bool isBlack = p.r == 0.0F && p.g == 0.0F && p.b == 0.0F;
      const bool right =
          mask(x, y) != 0 ? p.a == 1.0F : p.a == 0.0F && (isBlack || isNearPaint(x, y));
      if (right) continue;
      return ::testing::AssertionFailure()
             << path << ": pixel (" << x << ", " << y << ") is (" << p.r << ", " << p.g << ", "
             << p.b << ", " << p.a << "), " << (mask(x, y) != 0 ? "inside" : "outside")
             << " the mask";
    }
  }
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult failedWith(int exitCode, const std::string& message,
                                      const ProcessResult& result) {
  if (result.exitCode == exitCode && result.err == kErrorPrefix + message + "\n" &&
      result.out.empty()) {
    return ::testing::AssertionSuccess();
  }
  return describe(("wanted exit code " + std::to_string(exitCode) + " and " + message).c_str(),
                  result);
}

::testing::AssertionResult failedNaming(int exitCode, const std::string& beginning,
                                        const std::vector<std::string>& parts,
                                        const ProcessResult& result) {
  const bool oneLine = !result.err.empty() && result.err.find('\n') == result.err.size() - 1;
  const bool named = result.err.find(kErrorPrefix + beginning) == 0;
  const bool complete = std::all_of(parts.begin(), parts.end(), [&](const std::string& part) {
    return result.err.find(part) != std::string::npos;
  });
  if (result.exitCode == exitCode && result.out.empty() && oneLine && named && complete) {
    return ::testing::AssertionSuccess();
  }
  std::string wanted = "wanted exit code " + std::to_string(exitCode) + " and one line, " +
                       kErrorPrefix + beginning + "...";
  for (const std::string& part : parts) wanted += part + "...";
  return describe(wanted.c_str(), result);
}

}  // namespace fluidymation::test

// Writes what the fuzzers start from: write_seeds CORPUS makes CORPUS/png, CORPUS/flow and so on.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "checkpoint/manifest.h"
#include "cli/config_file.h"
#include "cli/painter_syntax.h"
#include "state_example.h"
#include "support/png_maker.h"

namespace fluidymation::fuzz {
namespace {

namespace fs = std::filesystem;

using test::Bytes;
using test::bytesOf;
using test::PngColor;
using test::PngSpec;

void write(const fs::path& path, const Bytes& bytes) {
  fs::create_directories(path.parent_path());
  test::writeBytes(path.string(), bytes);
}

[[nodiscard]] PngSpec picture(PngColor color, int bitDepth, bool interlaced) {
  PngSpec spec;
  spec.size = {7, 5};
  spec.color = color;
  spec.bitDepth = bitDepth;
  spec.interlaced = interlaced;
  std::mt19937 random(3);
  const int samples = 7 * 5 * test::channelsOf(color);
  for (int i = 0; i < samples; ++i) {
    spec.samples.push_back(static_cast<std::uint16_t>(random() & ((1U << bitDepth) - 1U)));
  }
  if (color == PngColor::kPalette) {
    for (int i = 0; i < 1 << bitDepth; ++i) {
      spec.palette.push_back({static_cast<std::uint8_t>(50 * i), 20, 90});
    }
    spec.paletteAlpha = {0, 128};
  }
  return spec;
}

void writePngs(const fs::path& folder) {
  for (const bool interlaced : {false, true}) {
    const std::string ending = interlaced ? "_interlaced.png" : ".png";
    write(folder / ("gray1" + ending), test::makePng(picture(PngColor::kGray, 1, interlaced)));
    write(folder / ("gray8" + ending), test::makePng(picture(PngColor::kGray, 8, interlaced)));
    write(folder / ("palette2" + ending),
          test::makePng(picture(PngColor::kPalette, 2, interlaced)));
    write(folder / ("rgb16" + ending), test::makePng(picture(PngColor::kRgb, 16, interlaced)));
    write(folder / ("gray_alpha8" + ending),
          test::makePng(picture(PngColor::kGrayAlpha, 8, interlaced)));
    write(folder / ("rgba8" + ending), test::makePng(picture(PngColor::kRgba, 8, interlaced)));
  }
  PngSpec odd = picture(PngColor::kRgb, 8, false);
  odd.gamma = 1.0;
  odd.transparent = {{10, 20, 30}};
  write(folder / "rgb8_gamma_transparent.png", test::makePng(odd));
  odd.gamma.reset();
  odd.srgb = true;
  write(folder / "rgb8_srgb.png", test::makePng(odd));
}

void appendNumber(Bytes& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 0xFFU));
  }
}

void writeFlows(const fs::path& folder) {
  constexpr std::uint32_t kTwo = 0x40000000U;      // 2 as a float
  constexpr std::uint32_t kUnknown = 0x4E6E6B28U;  // 1e9
  constexpr std::uint32_t kNoNumber = 0x7FC00000U;
  Bytes flow = bytesOf("PIEH");
  appendNumber(flow, 2);
  appendNumber(flow, 2);
  for (const std::uint32_t component : {kTwo, 0U, kUnknown, kUnknown, kNoNumber, 0U, 0U, kTwo}) {
    appendNumber(flow, component);
  }
  write(folder / "middlebury.flo", flow);
  write(folder / "kitti.png", test::makePng(picture(PngColor::kRgb, 16, false)));
}

void writePatterns(const fs::path& folder) {
  const std::vector<std::pair<std::string, std::string>> patterns = {
      {"plain", "frames/%05d.png"},   {"percent", "a%%b/rim_%d.PNG"}, {"wide", "/x/%20i"},
      {"two", "a/%d_%d.png"},         {"folder", "a%d/b.png"},        {"hostile", "%n%s%99999d"},
      {"unfinished", "frames/%0"},    {"no_number", "frames.png"},    {"bytes", "\xff\xfe%u.png"},
      {"control", "a\nb\x7f%3d.png"},
  };
  for (const auto& [name, text] : patterns) write(folder / name, bytesOf(text));
}

void writeOptions(const fs::path& folder) {
  const std::vector<std::string> required = {"--src-path", "s/%d.png",      "--src-mask-path",
                                             "m/%d.png",   "--target-path", "t/%d.png",
                                             "--out-path", "o/%d.png"};
  const std::vector<std::pair<std::string, std::vector<std::string>>> more = {
      {"required", {}},
      {"numbers",
       {"--src-start", "-3", "--src-scale", "0.5", "--lambda", "1e-3", "--seed",
        "18446744073709551615", "--opt-iterations", "5,0,1", "--prev-modulation-bounds", "7.5,0"}},
      {"words",
       {"--preset", "thesis", "--search", "everywhere", "--motion-model", "rigid", "--new-material",
        "fresh", "--temporal-coherence", "bidirectional"}},
      {"going_on", {"--resume", "--render-frames=-3--1", "--checkpoint-every", "4", "--quiet"}},
      {"contradiction", {"--resume", "--restart"}},
      {"flow", {"--src-flow-path", "f/%d.flo", "--flow-convention", "forward"}},
      {"slips", {"--lamda", "2", "--seed", "--threads", "1e300", "--quiet=yes", "extra"}},
      {"help", {"--help"}},
      {"verify", {"--verify", "fluidymation.json"}},
  };
  for (const auto& [name, options] : more) {
    Bytes bytes;
    std::vector<std::string> arguments = required;
    arguments.insert(arguments.end(), options.begin(), options.end());
    for (const std::string& argument : arguments) {
      bytes.insert(bytes.end(), argument.begin(), argument.end());
      bytes.push_back(0);
    }
    write(folder / name, bytes);
  }
}

void writeStates(const fs::path& folder) {
  const Bytes good = encodedState();
  write(folder / "good", good);
  Bytes other = good;
  other[16] ^= 1U;  // a letter of the version
  write(folder / "spoiled", other);
  forgeDigest(other.data(), other.size());
  write(folder / "of_another_run", other);
}

void writeManifests(const fs::path& folder) {
  Manifest manifest;
  manifest.fingerprint = stateFingerprint();
  manifest.paths = {{"--out-path", "out/%05d.png"}};
  manifest.complete = true;
  manifest.frames = {{1, "00001.png", digestOf("x", 1)}, {2, "00002.png", digestOf("y", 1)}};
  write(folder / "good.json", encode(manifest));
  manifest.complete = false;
  manifest.frames.pop_back();
  write(folder / "partial.json", encode(manifest));
  write(folder / "deep.json", bytesOf(std::string(1000, '[')));
  write(folder / "numbers.json",
        bytesOf(R"({"program":"fluidymation","format":1e300,"version":"\ud83d\ude00"})"));
}

void writeConfigs(const fs::path& folder) {
  const cli::CommandLine defaults;
  write(folder / "all.toml", bytesOf(cli::configText(cli::painterSyntax().table, defaults)));
  write(folder / "values.toml",
        bytesOf("# a shot\r\nsrc-path = \"s, #1/%d.png\"\nborder-width=12 # px\n"
                "opt-iterations = [4, 2]\npatchmatch-iterations = 5,3\nquiet = true\n"
                "src-range = '3-9x2'\n\tseed = 18446744073709551615\nmax-memory = 4G\n"));
  write(folder / "faults.toml",
        bytesOf("[section]\nborder-width\nno-such = 1\nseed =\nopt-iterations = [4,\nlambda = "
                "\"1\nsrc-path = \"a\" \"b\"\n"));
  Manifest manifest;
  manifest.fingerprint = stateFingerprint();
  manifest.paths = {{"--src-path", "s/%d.png"}, {"--out-path", "out/%05d.png"}};
  write(folder / "manifest.json", encode(manifest));
  for (const std::string line : {"border-width = 12", "opt-iterations = [4, 2]",
                                 "src-path = \"a # b\" # c", "= 1", "\xEF\xBB\xBFseed = 1"}) {
    write(folder / ("line" + std::to_string(line.size())), bytesOf(line + "\n"));
  }
}

}  // namespace
}  // namespace fluidymation::fuzz

int main(int argc, char** argv) {
  namespace fuzz = fluidymation::fuzz;
  if (argc != 2) {
    std::cerr << "usage: write_seeds CORPUS\n";
    return 2;
  }
  const std::filesystem::path corpus = argv[1];
  fuzz::writePngs(corpus / "png");
  fuzz::writeFlows(corpus / "flow");
  fuzz::writePatterns(corpus / "pattern");
  fuzz::writeOptions(corpus / "options");
  fuzz::writeStates(corpus / "state");
  fuzz::writeManifests(corpus / "manifest");
  fuzz::writeConfigs(corpus / "config");
  return 0;
}

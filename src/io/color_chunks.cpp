#include "fluidymation/io/color_chunks.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <tuple>

#include "io/png_reader.h"

namespace fluidymation {
namespace {

/// Which of the chunks stand in a file, rightly or not.
struct Present {
  bool srgb = false;
  bool gamma = false;
  bool chromaticities = false;
  bool profile = false;
};

/// Goes through the names of the chunks before the pixels. libpng, when asked, also tells of chunks
/// that follow from others.
[[nodiscard]] Present presentChunks(std::FILE* file) {
  constexpr std::size_t kLengthAndName = 8;
  constexpr long kCheckSumBytes = 4;
  constexpr int kMostChunks = 1000;  // files have some ten; behind so many nothing is looked for
  Present present;
  std::array<std::uint8_t, kLengthAndName> start{};
  std::fseek(file, static_cast<long>(kPngHeaderLength), SEEK_SET);
  for (int i = 0; i < kMostChunks; ++i) {
    if (std::fread(start.data(), 1, start.size(), file) != start.size()) break;
    const auto is = [&](const char* name) { return std::memcmp(start.data() + 4, name, 4) == 0; };
    if (is("IDAT") || is("IEND")) break;
    present.srgb = present.srgb || is("sRGB");
    present.gamma = present.gamma || is("gAMA");
    present.chromaticities = present.chromaticities || is("cHRM");
    present.profile = present.profile || is("iCCP");
    if (std::fseek(file, static_cast<long>(bigEndian(start.data())) + kCheckSumBytes, SEEK_CUR) !=
        0) {
      break;
    }
  }
  return present;
}

/// What libpng has made of them. Plain, for it is filled inside `libpng::attempt`.
struct Parsed {
  int intent = 0;
  png_fixed_point gamma = 0;
  std::array<png_fixed_point, 8> chromaticities{};
  png_charp profileName = nullptr;
  png_bytep profile = nullptr;
  png_uint_32 profileBytes = 0;
  bool hasIntent = false;
  bool hasGamma = false;
  bool hasChromaticities = false;
  bool undoesGamma = false;  ///< see `readPng`
};

void parse(png_structp png, png_infop info, Parsed& parsed) {
  setLimits(png, ColorPrimaries::kRead);
  png_read_info(png, info);
  parsed.undoesGamma = declaredGamma(png, info) != 0.0;
  parsed.hasIntent = png_get_sRGB(png, info, &parsed.intent) != 0;
  parsed.hasGamma = png_get_gAMA_fixed(png, info, &parsed.gamma) != 0;
  auto& [whiteX, whiteY, redX, redY, greenX, greenY, blueX, blueY] = parsed.chromaticities;
  parsed.hasChromaticities = png_get_cHRM_fixed(png, info, &whiteX, &whiteY, &redX, &redY, &greenX,
                                                &greenY, &blueX, &blueY) != 0;
  int compression = 0;
  png_get_iCCP(png, info, &parsed.profileName, &compression, &parsed.profile, &parsed.profileBytes);
}

/// Whether a profile is one of RGB pictures: painted frames have no other colours.
[[nodiscard]] bool isOfRgb(const Parsed& parsed) {
  constexpr png_uint_32 kColorSpace = 16;  // ICC.1, header: bytes 16 to 19
  return parsed.profile != nullptr && parsed.profileBytes >= kColorSpace + 4 &&
         std::memcmp(parsed.profile + kColorSpace, "RGB ", 4) == 0;
}

/// Whether a name is as the PNG specification wants keywords: printable Latin-1, no space at either
/// end, nor two of them together. libpng reads others, and refuses or changes them when it writes.
[[nodiscard]] bool isKeyword(const std::string& name) {
  constexpr std::size_t kMostBytes = 79;
  const auto isPrintable = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte >= 0x20 && byte <= 0x7E) || byte >= 0xA1;
  };
  return !name.empty() && name.size() <= kMostBytes && name.front() != ' ' && name.back() != ' ' &&
         name.find("  ") == std::string::npos && std::all_of(name.begin(), name.end(), isPrintable);
}

}  // namespace

bool operator==(const ColorChunks& a, const ColorChunks& b) {
  const auto same = [](const auto& one, const auto& other) {
    if (!one || !other) return one.has_value() == other.has_value();
    return one->name == other->name && one->bytes == other->bytes;
  };
  return a.srgbIntent == b.srgbIntent && a.gamma == b.gamma &&
         a.chromaticities == b.chromaticities && same(a.profile, b.profile);
}

std::string namesOf(const ColorChunks& chunks) {
  std::string names;
  for (const auto& [is, name] : {std::tuple{chunks.srgbIntent.has_value(), "sRGB"},
                                 {chunks.gamma.has_value(), "gAMA"},
                                 {chunks.chromaticities.has_value(), "cHRM"},
                                 {chunks.profile.has_value(), "iCCP"}}) {
    if (is) names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names.empty() ? "none" : names;
}

FoundColorChunks readColorChunks(const std::string& path) {
  constexpr std::int32_t kSrgbGamma = 45455;
  const InputFile input = openPng(path);
  std::FILE* const file = input.file.get();
  (void)readHeader(file, path);
  const Present present = presentChunks(file);
  std::rewind(file);
  PngReader reader(file, path);
  Parsed parsed;
  reader.run([&] { parse(reader.png(), reader.info(), parsed); });

  FoundColorChunks found;
  const auto take = [&](bool isThere, bool isGood, const char* name, const auto& store) {
    if (!isThere) return;
    if (isGood) {
      store();
    } else {
      found.refused += (found.refused.empty() ? "" : ", ") + std::string(name);
    }
  };
  ColorChunks& chunks = found.chunks;
  take(present.profile, isOfRgb(parsed), "iCCP", [&] {
    const std::string name = parsed.profileName;
    chunks.profile = {isKeyword(name) ? name : kUnnamedProfile,
                      {parsed.profile, parsed.profile + parsed.profileBytes}};
  });
  // A profile says it all, and may not stand beside an sRGB chunk
  take(present.srgb, parsed.hasIntent && !chunks.profile, "sRGB",
       [&] { chunks.srgbIntent = parsed.intent; });
  take(present.gamma, parsed.hasGamma, "gAMA",
       [&] { chunks.gamma = parsed.undoesGamma ? kSrgbGamma : parsed.gamma; });
  take(present.chromaticities, parsed.hasChromaticities, "cHRM",
       [&] { chunks.chromaticities = parsed.chromaticities; });
  return found;
}

}  // namespace fluidymation

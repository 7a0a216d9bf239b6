#include "footage/film_mask_files.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

#include "fluidymation/core/error.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/png.h"
#include "pipeline/machine_memory.h"
#include "pipeline/protected_files.h"

namespace fluidymation {
namespace {

namespace fs = std::filesystem;

void requireOptions(const FilmMaskOptions& options) {
  checkPattern("--src-path", options.film.path);
  checkOutputPattern("--out-path", options.maskPath);
  if (options.mattePath) checkOutputPattern("--matte-path", *options.mattePath);
  const auto require = [](bool isFine, const std::string& option, const Range& range) {
    if (!isFine) throw UsageError(option + ": wanted a number in " + range.text());
  };
  require(ranges::kBareFrames.contains(options.bareFrames), "--bare-frames", ranges::kBareFrames);
  require(!options.threshold || ranges::kDifferences.contains(*options.threshold), "--threshold",
          ranges::kDifferences);
  require(ranges::kSigmasPx.contains(options.grainSigmaPx), "--grain-sigma", ranges::kSigmasPx);
  for (const auto& [size, option] : {std::pair{options.smallestPartPx, "--smallest-part"},
                                     std::pair{options.smallestHolePx, "--smallest-hole"}}) {
    require(!size || ranges::kPartSizesPx.contains(*size), option, ranges::kPartSizesPx);
  }
  if (options.barePath && options.bareFrames > 1) {
    throw UsageError(
        "--bare, --bare-frames: wanted one of them, the surface from a picture or from "
        "the film's first frames");
  }
}

/// @throws Error where the bare surface's file does not have the film's size.
void requireSize(const std::optional<std::string>& path, Size size, const std::string& film) {
  if (!path) return;
  const Size found = readPngSize(*path);
  if (found == size) return;
  throw Error(*path + ": " + std::to_string(found.width) + "x" + std::to_string(found.height) +
              ", but " + film + " is " + std::to_string(size.width) + "x" +
              std::to_string(size.height) +
              "; wanted a picture from the same place, of the same size");
}

/// @throws Error where the film is too large for this machine.
void requireMemory(const FilmMaskOptions& options, Size size) {
  // Frame as read, colours, differences, parts, masks; each first frame as colours
  constexpr double kBytesAPixel = 120.0;
  constexpr double kBytesAPixelAndBareFrame = 12.0;
  constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;
  const double bytes = static_cast<double>(size.width) * size.height *
                       (kBytesAPixel + kBytesAPixelAndBareFrame * options.bareFrames);
  if (bytes <= static_cast<double>(machineMemoryBytes())) return;
  throw Error("--src-path " + options.film.path + ": its masks need " +
              std::to_string(static_cast<std::int64_t>(bytes / kGibibyte) + 1) +
              " GiB of memory, more than there is; scale the film down, or take fewer "
              "--bare-frames");
}

[[nodiscard]] bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return canonical(a) == canonical(b) || fs::equivalent(a, b, ignored);
}

/// What has been promised to be written, and what must not be.
class Outputs {
 public:
  explicit Outputs(const FilmMaskOptions& options)
      : options_(options), film_(std::vector<std::string>{options.film.path}) {}

  /// @throws UsageError where `path` is an input or another output; Error where it cannot be
  /// replaced.
  void add(const std::string& option, const std::string& path) {
    const bool isBare = (options_.barePath && isSameFile(path, *options_.barePath)) ||
                        (options_.barePaintPath && isSameFile(path, *options_.barePaintPath));
    if (isBare || film_.contains(path)) {
      throw UsageError(option + ": " + path +
                       " is an input and would be overwritten; choose another name");
    }
    if (!taken_.insert(canonical(path)).second) {
      throw UsageError(option + ": " + path + " is written already; choose another name");
    }
    checkReplaceable(path);
    std::error_code ignored;
    if (fs::exists(path, ignored)) existing_.push_back(path);
  }

  /// Masks may have been retouched. @throws Error where files are there already.
  void requireNew() const {
    if (existing_.empty() || options_.overwrite) return;
    const std::size_t others = existing_.size() - 1;
    throw Error(existing_.front() + ": is there already" +
                (others == 0 ? ""
                             : (others == 1 ? "; so is " : "; so are ") + std::to_string(others) +
                                   " more") +
                "; wanted --overwrite to replace, or another --out-path");
  }

 private:
  const FilmMaskOptions& options_;
  ProtectedFiles film_;
  std::set<fs::path> taken_;
  std::vector<std::string> existing_;
};

[[nodiscard]] std::string folderOf(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

[[nodiscard]] std::vector<std::string> outputFolders(const FilmMaskOptions& options) {
  std::vector<std::string> folders = {FramePattern(options.maskPath).folder()};
  if (options.mattePath) folders.push_back(FramePattern(*options.mattePath).folder());
  if (options.sheetPath) folders.push_back(folderOf(*options.sheetPath));
  return folders;
}

}  // namespace

FilmMaskFiles openFilm(const FilmMaskOptions& options) {
  requireOptions(options);
  FilmMaskFiles files;
  files.film = findFrames(FramePattern(options.film.path), options.film, "--src-path");
  files.size = commonSize(files.film);
  requireSize(options.barePath, files.size, files.film.paths.front());
  requireSize(options.barePaintPath, files.size, files.film.paths.front());
  requireMemory(options, files.size);
  Outputs outputs(options);
  const auto add = [&](const std::string& option, const std::string& pattern) {
    const std::string given = option + " " + pattern;
    const FramePattern frames(pattern);
    std::vector<std::string> paths;
    for (const int number : files.film.numbers) {
      paths.push_back(frames.path(number));
      outputs.add(given, paths.back());
    }
    return paths;
  };
  files.masks = add("--out-path", options.maskPath);
  if (options.mattePath) files.mattes = add("--matte-path", *options.mattePath);
  outputs.requireNew();
  if (options.sheetPath) {
    if (fs::path(*options.sheetPath).extension() != ".png") {
      throw UsageError("--sheet " + *options.sheetPath + ": wanted a name that ends in .png");
    }
    outputs.add("--sheet", *options.sheetPath);
  }
  for (const std::string& folder : outputFolders(options)) checkFolderCreatable(folder);
  return files;
}

void createFolders(const FilmMaskOptions& options) {
  for (const std::string& folder : outputFolders(options)) {
    createFolder(folder);
    checkFolderWritable(folder);
  }
}

}  // namespace fluidymation

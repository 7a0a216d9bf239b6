#include "pipeline/outputs.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "fluidymation/core/error.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/dump_name.h"
#include "fluidymation/io/frame_pattern.h"

namespace fluidymation {
namespace {

/// One spelling for all paths to a file, also in folders that are still to be created.
std::filesystem::path canonical(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  fs::path resolved = fs::absolute(path, ignored);
  // A folder that does not exist yet is not resolved, and the ".." behind it may lead to a link:
  // hence twice.
  for (int i = 0; i < 2; ++i) {
    const fs::path once = fs::weakly_canonical(resolved, ignored);
    resolved = ignored ? resolved.lexically_normal() : once;
  }
  return resolved;
}

/// Device and inode: equal for two names of one file.
using Identity = std::pair<dev_t, ino_t>;

std::optional<Identity> identityOf(const std::filesystem::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return Identity{status.st_dev, status.st_ino};
}

/// Everything that may be an input of this run or of another one with the same patterns.
class ProtectedFiles {
 public:
  explicit ProtectedFiles(const Options& options) {
    for (const std::string& text :
         {options.source.path, options.sourceMaskPath, options.target.path}) {
      add(FramePattern(text));
    }
  }

  /// Whether writing `path` would replace one, under whatever name it is known.
  [[nodiscard]] bool contains(const std::string& path) const {
    const std::filesystem::path resolved = canonical(path);
    // The entry of the folder is what is replaced, also where it is a link to elsewhere.
    const std::filesystem::path given = path;
    const std::filesystem::path entry =
        canonical((given.has_parent_path() ? given.parent_path() : ".").string()) /
        given.filename();
    return matches(resolved) || matches(entry) || isLinked(path);
  }

  /// Whether `path` is another name of one: a link of any kind.
  [[nodiscard]] bool isLinked(const std::filesystem::path& path) const {
    const std::optional<Identity> identity = identityOf(path);
    return identity && identities_.count(*identity) != 0;
  }

  /// The patterns' files that are in `folder` (canonical): those that exist, and those numbered so.
  [[nodiscard]] std::vector<std::string> namesIn(const std::filesystem::path& folder,
                                                 const std::vector<int>& numbers) const {
    std::vector<std::string> names;
    for (const Place& place : places_) {
      if (place.folder != folder) continue;
      names.insert(names.end(), place.names.begin(), place.names.end());
      for (const int number : numbers) {
        names.push_back(std::filesystem::path(place.pattern.path(number)).filename().string());
      }
    }
    return names;
  }

 private:
  /// A pattern's folder (canonical) and what it holds of the pattern.
  struct Place {
    FramePattern pattern;
    std::filesystem::path folder;
    std::vector<std::string> names;
  };

  void add(const FramePattern& pattern) {
    Place place{pattern, canonical(pattern.folder()), {}};
    std::error_code failure;  // folders that cannot be read have been complained about before
    std::filesystem::directory_iterator entry(pattern.folder(), failure);
    for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
      const std::string name = entry->path().filename().string();
      if (!pattern.numberOf(name)) continue;
      place.names.push_back(name);
      targets_.insert(canonical(entry->path().string()));
      if (const auto identity = identityOf(entry->path())) identities_.insert(*identity);
    }
    places_.push_back(std::move(place));
  }

  [[nodiscard]] bool matches(const std::filesystem::path& path) const {
    const auto isIn = [&](const Place& place) {
      return path.parent_path() == place.folder &&
             place.pattern.numberOf(path.filename().string()).has_value();
    };
    return targets_.count(path) != 0 || std::any_of(places_.begin(), places_.end(), isIn);
  }

  std::vector<Place> places_;
  std::set<std::filesystem::path> targets_;  ///< where the patterns' files really are
  std::set<Identity> identities_;
};

/// Whether a dump into `folder` can write `path`.
bool isDumpFile(const std::filesystem::path& folder, const std::filesystem::path& path) {
  return path.parent_path() == folder && isDumpName(path.filename().string());
}

/// Names of dumped files in `folder` that are inputs or links to such.
std::vector<std::string> endangeredNames(const std::string& folder, const ProtectedFiles& inputs,
                                         const std::vector<int>& numbers) {
  std::vector<std::string> names;
  for (const std::string& name : inputs.namesIn(canonical(folder), numbers)) {
    if (isDumpName(name)) names.push_back(name);
  }
  std::error_code failure;
  std::filesystem::directory_iterator entry(folder, failure);
  for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    if (isDumpName(name) && inputs.isLinked(entry->path())) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// @throws UsageError where the dump would replace a painted frame or an input.
void checkDump(const Options& options, const Inputs& inputs, const ProtectedFiles& protectedFiles,
               const std::vector<std::string>& painted) {
  const std::string option = "--dump-guides " + *options.dumpGuidesDirectory + ": ";
  for (const bool source : {true, false}) {
    const std::string folder = dumpFolder(options, source ? "source" : "target");
    const std::vector<int>& numbers = (source ? inputs.color : inputs.target).files.numbers;
    const std::vector<std::string> endangered = endangeredNames(folder, protectedFiles, numbers);
    if (!endangered.empty()) {
      throw UsageError(option + folder + "/" + endangered.front() +
                       " is an input and would be overwritten; choose another folder");
    }
    for (const std::string& path : painted) {
      if (!isDumpFile(canonical(folder), canonical(path))) continue;
      throw UsageError(option + path + " is a painted frame; choose another folder");
    }
  }
}

/// Everything that is written to, the folder of the frames first.
std::vector<std::string> outputFolders(const Options& options) {
  std::vector<std::string> folders = {FramePattern(options.outPath).folder()};
  if (options.dumpGuidesDirectory) {
    folders.push_back(dumpFolder(options, "source"));
    folders.push_back(dumpFolder(options, "target"));
  }
  return folders;
}

}  // namespace

std::string dumpFolder(const Options& options, const std::string& sequence) {
  return (std::filesystem::path(*options.dumpGuidesDirectory) / sequence).string();
}

std::vector<std::string> checkOutput(const Options& options, const Inputs& inputs) {
  const FramePattern pattern(options.outPath);
  const ProtectedFiles protectedFiles(options);
  std::vector<std::string> paths;
  for (const int number : inputs.target.files.numbers) {
    paths.push_back(pattern.path(number));
    if (protectedFiles.contains(paths.back())) {
      throw UsageError("--out-path " + options.outPath + ": " + paths.back() +
                       " is an input and would be overwritten; choose another --out-path");
    }
  }
  if (options.dumpGuidesDirectory) checkDump(options, inputs, protectedFiles, paths);
  for (const std::string& folder : outputFolders(options)) checkFolderCreatable(folder);
  for (const std::string& path : paths) checkReplaceable(path);
  return paths;
}

void createOutputFolders(const Options& options, const std::vector<std::string>& paths) {
  for (const std::string& folder : outputFolders(options)) {
    createFolder(folder);
    checkFolderWritable(folder);
  }
  // Once more: in a folder that did not exist nothing could be said about names.
  for (const std::string& path : paths) checkReplaceable(path);
}

}  // namespace fluidymation

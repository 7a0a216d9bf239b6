#include "pipeline/protected_files.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>

#include "pipeline/backdrop.h"

namespace fluidymation {

namespace fs = std::filesystem;

fs::path canonical(const std::string& path) {
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

ProtectedFiles::ProtectedFiles(const Options& options) {
  for (const std::string& text :
       {options.source.path, options.sourceMaskPath, options.target.path}) {
    add(FramePattern(text));
  }
  for (const auto& flowPath : {options.sourceFlowPath, options.targetFlowPath}) {
    if (flowPath) add(FramePattern(*flowPath));
  }
  if (options.background && isBackgroundFile(*options.background)) addFile(*options.background);
}

ProtectedFiles::ProtectedFiles(const std::vector<std::string>& patterns,
                               const std::vector<std::string>& files) {
  for (const std::string& text : patterns) add(FramePattern(text));
  for (const std::string& path : files) addFile(path);
}

bool ProtectedFiles::contains(const std::string& path) const {
  // The entry of the folder is what is replaced, also where it is a link to elsewhere.
  const fs::path given = path;
  const std::string folder = given.has_parent_path() ? given.parent_path().string() : ".";
  return matches(canonical(folder) / given.filename()) || matches(canonical(path)) ||
         isLinked(given);
}

bool ProtectedFiles::isLinked(const fs::path& path) const {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && identities_.count({status.st_dev, status.st_ino}) != 0;
}

std::vector<std::string> ProtectedFiles::namesIn(const fs::path& folder,
                                                 const std::vector<int>& numbers) const {
  std::vector<std::string> names;
  for (const Place& place : places_) {
    if (place.folder != folder) continue;
    names.insert(names.end(), place.names.begin(), place.names.end());
    for (const int number : numbers) {
      names.push_back(fs::path(place.pattern.path(number)).filename().string());
    }
  }
  return names;
}

void ProtectedFiles::add(const FramePattern& pattern) {
  Place place{pattern, canonical(pattern.folder()), {}};
  std::error_code failure;  // folders that cannot be read have been complained about before
  fs::directory_iterator entry(pattern.folder(), failure);
  for (; !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    if (!pattern.numberOf(name)) continue;
    place.names.push_back(name);
    addFile(entry->path());
  }
  places_.push_back(std::move(place));
}

void ProtectedFiles::addFile(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) == 0) identities_.insert({status.st_dev, status.st_ino});
}

bool ProtectedFiles::matches(const fs::path& path) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    return path.parent_path() == place.folder &&
           place.pattern.numberOf(path.filename().string()).has_value();
  });
}

}  // namespace fluidymation

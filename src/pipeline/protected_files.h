#pragma once

#include <sys/types.h>

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// One spelling for all paths to a file, also in folders that are still to be created.
[[nodiscard]] std::filesystem::path canonical(const std::string& path);

/// Everything that may be an input of this run or of another one with the same patterns: the
/// patterns' files, those that would be theirs if they existed, and a background's file.
class ProtectedFiles {
 public:
  /// Lists the folders of all input patterns.
  explicit ProtectedFiles(const Options& options);

  /// The same for these patterns, and single files that are there.
  /// @throws UsageError for what is no pattern.
  explicit ProtectedFiles(const std::vector<std::string>& patterns,
                          const std::vector<std::string>& files = {});

  /// Whether writing `path` would replace one, under whatever name it is known.
  [[nodiscard]] bool contains(const std::string& path) const;

  /// Whether `path` is another name of an existing one: a link of any kind.
  [[nodiscard]] bool isLinked(const std::filesystem::path& path) const;

  /// Names of those that are in `folder` (canonical): all that exist, and those of these numbers.
  [[nodiscard]] std::vector<std::string> namesIn(const std::filesystem::path& folder,
                                                 const std::vector<int>& numbers) const;

 private:
  /// A pattern, its folder (canonical) and the names of its files there.
  struct Place {
    FramePattern pattern;
    std::filesystem::path folder;
    std::vector<std::string> names;
  };
  /// Device and inode: equal for two names of one file.
  using Identity = std::pair<dev_t, ino_t>;

  void add(const FramePattern& pattern);
  /// One that exists.
  void addFile(const std::filesystem::path& path);
  [[nodiscard]] bool matches(const std::filesystem::path& path) const;

  std::vector<Place> places_;
  std::set<Identity> identities_;
};

}  // namespace fluidymation

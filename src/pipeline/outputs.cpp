#include "pipeline/outputs.h"

#include <filesystem>
#include <set>
#include <system_error>

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

/// Whether a dump into `folder` can write `path`.
bool isDumpFile(const std::filesystem::path& folder, const std::filesystem::path& path) {
  return path.parent_path() == folder && isDumpName(path.filename().string());
}

/// @throws UsageError where the dump would replace a painted frame or anything that is read.
void checkDump(const Options& options, const std::set<std::filesystem::path>& read,
               const std::vector<std::string>& painted) {
  const std::string option = "--dump-guides " + *options.dumpGuidesDirectory + ": ";
  for (const char* sequence : {"source", "target"}) {
    const std::string folder = dumpFolder(options, sequence);
    const std::filesystem::path resolved = canonical(folder);
    for (const std::filesystem::path& path : read) {
      if (!isDumpFile(resolved, path)) continue;
      throw UsageError(option + folder + "/" + path.filename().string() +
                       " is an input and would be overwritten; choose another folder");
    }
    for (const std::string& path : painted) {
      if (!isDumpFile(resolved, canonical(path))) continue;
      throw UsageError(option + path + " is a painted frame; choose another folder");
    }
  }
}

void createWritableFolder(const std::string& folder) {
  createFolder(folder);
  checkFolderWritable(folder);
}

}  // namespace

std::string dumpFolder(const Options& options, const std::string& sequence) {
  return (std::filesystem::path(*options.dumpGuidesDirectory) / sequence).string();
}

std::vector<std::string> prepareOutput(const Options& options, const Inputs& inputs) {
  const FramePattern pattern(options.outPath);
  std::set<std::filesystem::path> read;
  for (const InputSequence* input : {&inputs.color, &inputs.sourceMask, &inputs.target}) {
    for (const std::string& path : input->files.paths) read.insert(canonical(path));
  }
  std::vector<std::string> paths;
  for (const int number : inputs.target.files.numbers) {
    paths.push_back(pattern.path(number));
    if (read.count(canonical(paths.back())) != 0) {
      throw UsageError("--out-path " + options.outPath + ": " + paths.back() +
                       " is an input and would be overwritten; choose another --out-path");
    }
  }
  if (options.dumpGuidesDirectory) checkDump(options, read, paths);

  createWritableFolder(pattern.folder());
  for (const std::string& path : paths) checkReplaceable(path);
  if (options.dumpGuidesDirectory) {
    createWritableFolder(dumpFolder(options, "source"));
    createWritableFolder(dumpFolder(options, "target"));
  }
  return paths;
}

}  // namespace fluidymation

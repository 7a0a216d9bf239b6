#include "pipeline/outputs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include "fluidymation/core/error.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/frame_pattern.h"
#include "pipeline/dump_name.h"

namespace fluidymation {
namespace {

/// Whether a dump into `folder` can write `path`.
bool isDumpFile(const std::filesystem::path& folder, const std::filesystem::path& path) {
  return path.parent_path() == folder && isDumpName(path.filename().string());
}

/// `folder` (canonical) and all it is in: what is created where it is missing.
std::vector<std::filesystem::path> withParents(std::filesystem::path folder) {
  std::vector<std::filesystem::path> folders;
  for (; folder.has_relative_path(); folder = folder.parent_path()) folders.push_back(folder);
  return folders;
}

/// Names in `folder` that a dump could write and that are there already.
std::vector<std::string> existingDumpNames(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code failure;  // a folder that is missing or cannot be read holds none
  std::filesystem::directory_iterator entry(folder, failure);
  for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    if (isDumpName(name)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Names of dumped files in `folder` that are inputs or links to such.
std::vector<std::string> endangeredNames(const std::string& folder, const ProtectedFiles& inputs,
                                         const std::vector<int>& numbers) {
  std::vector<std::string> names;
  for (const std::string& name : inputs.namesIn(canonical(folder), numbers)) {
    if (isDumpName(name)) names.push_back(name);
  }
  for (const std::string& name : existingDumpNames(folder)) {
    if (inputs.isLinked(std::filesystem::path(folder) / name)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// @throws UsageError where a painted frame and the dump want one name, for a file or for a folder
/// on the way to one.
void requireApart(const Options& options, const std::vector<std::string>& dumpFolders,
                  const std::vector<std::string>& painted) {
  const std::string option = "--dump-guides " + *options.dumpGuidesDirectory + ": ";
  const std::string frameFolder = FramePattern(options.outPath).folder();
  const std::vector<std::filesystem::path> frameFolders = withParents(canonical(frameFolder));
  std::map<std::filesystem::path, std::string> frames;
  for (const std::string& path : painted) frames.emplace(canonical(path), path);
  for (const std::string& dumpFolder : dumpFolders) {
    const std::filesystem::path folder = canonical(dumpFolder);
    for (const auto& [frame, path] : frames) {
      if (!isDumpFile(folder, frame)) continue;
      throw UsageError(option + path + " is a painted frame; choose another folder");
    }
    for (const std::filesystem::path& onTheWay : withParents(folder)) {
      const auto frame = frames.find(onTheWay);
      if (frame == frames.end()) continue;
      throw UsageError(option + frame->second + " is a painted frame; choose another folder");
    }
    for (const std::filesystem::path& onTheWay : frameFolders) {
      if (!isDumpFile(folder, onTheWay)) continue;
      throw UsageError(option + dumpFolder + "/" + onTheWay.filename().string() +
                       " is on the way to the painted frames; choose another folder");
    }
  }
}

/// @throws UsageError where the dump would replace a painted frame, an input or itself; Error where
/// a name is taken by something that cannot be replaced.
void checkDump(const Options& options, const Inputs& inputs, const ProtectedFiles& protectedFiles,
               const std::vector<std::string>& painted) {
  const std::string option = "--dump-guides " + *options.dumpGuidesDirectory + ": ";
  const std::string sourceFolder = dumpFolder(options, "source");
  const std::string targetFolder = dumpFolder(options, "target");
  if (canonical(sourceFolder) == canonical(targetFolder)) {
    throw UsageError(option + sourceFolder + " and " + targetFolder +
                     " are one folder; choose another folder");
  }
  for (const bool source : {true, false}) {
    const std::string& folder = source ? sourceFolder : targetFolder;
    const std::vector<int>& numbers = (source ? inputs.color : inputs.target).files.numbers;
    const std::vector<std::string> endangered = endangeredNames(folder, protectedFiles, numbers);
    if (!endangered.empty()) {
      throw UsageError(option + folder + "/" + endangered.front() +
                       " is an input and would be overwritten; choose another folder");
    }
  }
  requireApart(options, {sourceFolder, targetFolder}, painted);
  for (const std::string& folder : {sourceFolder, targetFolder}) {
    for (const std::string& name : existingDumpNames(folder)) {
      checkReplaceable((std::filesystem::path(folder) / name).string());
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

/// Later runs would take such a folder for a frame of the input.
/// @throws UsageError when `folder`, or one on the way to it, is missing and has an input's name.
void requireNoFrameNames(const std::string& option, const std::string& folder,
                         const ProtectedFiles& protectedFiles) {
  std::error_code ignored;
  for (const std::filesystem::path& onTheWay : withParents(canonical(folder))) {
    if (std::filesystem::exists(onTheWay, ignored)) return;
    if (!protectedFiles.contains(onTheWay.string())) continue;
    throw UsageError(option + ": a folder " + onTheWay.string() +
                     " would have the name of an input; choose another one");
  }
}

}  // namespace

void requireNoInputAmongRecords(const RunFiles& files, const ProtectedFiles& protectedFiles) {
  std::vector<std::string> records = {files.manifest()};
  std::error_code ignored;  // most often there is no such folder
  for (std::filesystem::directory_iterator entry(files.hiddenFolder(), ignored);
       !ignored && entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
    records.push_back(entry->path().string());
  }
  for (const std::string& record : records) {
    if (!protectedFiles.contains(record)) continue;
    throw UsageError("--out-path " + files.pattern() + ": " + record +
                     " is an input and has the place of what the run keeps beside its frames; "
                     "choose another --out-path");
  }
}

std::string dumpFolder(const Options& options, const std::string& sequence) {
  return (std::filesystem::path(*options.dumpGuidesDirectory) / sequence).string();
}

std::vector<std::string> checkOutput(const Options& options, const Inputs& inputs) {
  return checkOutput(options, inputs, ProtectedFiles(options));
}

std::vector<std::string> checkOutput(const Options& options, const Inputs& inputs,
                                     const ProtectedFiles& protectedFiles) {
  const FramePattern pattern(options.outPath);
  std::vector<std::string> paths;
  for (const int number : inputs.target.files.numbers) {
    paths.push_back(pattern.path(number));
    if (protectedFiles.contains(paths.back())) {
      throw UsageError("--out-path " + options.outPath + ": " + paths.back() +
                       " is an input and would be overwritten; choose another --out-path");
    }
  }
  requireNoInputAmongRecords(RunFiles(pattern), protectedFiles);
  requireNoFrameNames("--out-path " + options.outPath, pattern.folder(), protectedFiles);
  if (options.dumpGuidesDirectory) {
    checkDump(options, inputs, protectedFiles, paths);
    for (const char* sequence : {"source", "target"}) {
      requireNoFrameNames("--dump-guides " + *options.dumpGuidesDirectory,
                          dumpFolder(options, sequence), protectedFiles);
    }
  }
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

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/layers.h"
#include "fluidymation/option_ranges.h"
#include "layers/composited_frames.h"
#include "layers/layer_inputs.h"
#include "pipeline/outputs.h"
#include "pipeline/protected_files.h"

namespace fluidymation {
namespace {

/// The patterns of everything that any layer reads.
[[nodiscard]] std::vector<std::string> inputPatterns(const std::vector<Layer>& layers) {
  std::vector<std::string> patterns;
  for (const Layer& layer : layers) {
    const Options& options = layer.options;
    for (const std::string& path :
         {options.source.path, options.sourceMaskPath, options.target.path}) {
      patterns.push_back(path);
    }
    for (const auto& path : {options.sourceFlowPath, options.targetFlowPath}) {
      if (path) patterns.push_back(*path);
    }
  }
  return patterns;
}

/// The pictures of backgrounds.
[[nodiscard]] std::vector<std::string> inputFiles(const LayeredShot& shot,
                                                  const LayerInputs& layers) {
  std::vector<std::string> files;
  if (layers.background) files.push_back(*shot.background);
  for (std::size_t i = 0; i < shot.layers.size(); ++i) {
    if (layers.inputs[i].background) files.push_back(*shot.layers[i].options.background);
  }
  return files;
}

/// Files that are to be written, and who writes them.
class OutputFiles {
 public:
  explicit OutputFiles(const ProtectedFiles& inputs) : inputs_(inputs) {}

  /// @throws UsageError where `path` is read, or written by another one.
  void add(const std::string& owner, const std::string& path) {
    if (inputs_.contains(path)) {
      throw UsageError(owner + ": " + path +
                       " is an input and would be overwritten; choose another --out-path");
    }
    const auto [known, isNew] = owners_.emplace(canonical(path).string(), owner);
    if (isNew) return;
    throw UsageError(owner + ": " + path + " is written by " + known->second +
                     ", too; choose another --out-path");
  }

  /// @throws UsageError where a layer dumps into a folder of frames; once all are added.
  void requireDumpsApart() const {
    for (const auto& [path, owner] : owners_) {
      const std::string folder = std::filesystem::path(path).parent_path().string();
      const auto dumper = dumpers_.find(folder);
      if (dumper == dumpers_.end()) continue;
      throw UsageError("layer " + dumper->second + ": --dump-guides: " + folder +
                       " is a folder of painted frames; choose another folder");
    }
  }

  /// @throws UsageError where the layer dumps into a folder of another one's dump.
  void addDump(const Layer& layer) {
    if (!layer.options.dumpGuidesDirectory) return;
    for (const char* sequence : {"source", "target"}) {
      const std::string folder = dumpFolder(layer.options, sequence);
      const auto [known, isNew] = dumpers_.emplace(canonical(folder).string(), layer.name);
      if (isNew) continue;
      throw UsageError("layer " + layer.name + ": --dump-guides " +
                       *layer.options.dumpGuidesDirectory + ": " + folder +
                       " is written by layer " + known->second + ", too; choose another folder");
    }
  }

 private:
  const ProtectedFiles& inputs_;
  std::map<std::string, std::string> owners_;
  std::map<std::string, std::string> dumpers_;  ///< layers by the folders of their dumps
};

void checkOutputs(const LayeredShot& shot, const LayerInputs& layers) {
  const ProtectedFiles inputs(inputPatterns(shot.layers), inputFiles(shot, layers));
  OutputFiles files(inputs);
  for (std::size_t i = 0; i < shot.layers.size(); ++i) {
    const Layer& layer = shot.layers[i];
    std::vector<std::string> paths;
    inLayer(layer.name, [&] { paths = checkOutput(layer.options, layers.inputs[i], inputs); });
    for (const std::string& path : paths) files.add("layer " + layer.name, path);
    files.addDump(layer);
  }
  const FramePattern pattern(shot.outPath);
  for (const int number : layers.numbers) files.add("--out-path", pattern.path(number));
  files.requireDumpsApart();
  requireNoInputAmongRecords(RunFiles(pattern), inputs);
  checkFolderCreatable(pattern.folder());
  for (const int number : layers.numbers) checkReplaceable(pattern.path(number));
}

/// The film's surface takes long to find, all else is looked at.
void checkBackground(const LayeredShot& shot, const LayerInputs& layers,
                     const std::function<void()>& stopIfWanted) {
  if (layerOfBackground(shot)) return;
  (void)bottomOf(shot, layers, stopIfWanted);
}

}  // namespace

void checkLayers(const LayeredShot& shot, const Observer& observer) {
  checkOutputPattern("--out-path", shot.outPath);
  const LayerInputs layers = openLayers(shot);
  checkOutputs(shot, layers);
  const auto stopIfWanted = [&observer] {
    if (observer.cancelled && observer.cancelled()) throw Interrupted("interrupted");
  };
  checkBackground(shot, layers, stopIfWanted);
  requireOwnComposite(shot, layers, stopIfWanted);
  if (!observer.note) return;
  for (const std::string& note : notesOnLengths(layers.frames, layers.numbers)) {
    observer.note(note);
  }
}

}  // namespace fluidymation

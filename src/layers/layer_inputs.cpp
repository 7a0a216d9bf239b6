#include "layers/layer_inputs.h"

#include <algorithm>
#include <string>

#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "fluidymation/option_ranges.h"
#include "pipeline/backdrop.h"

namespace fluidymation {
namespace {

[[nodiscard]] std::string namesOf(const std::vector<Layer>& layers) {
  std::string names;
  for (const Layer& layer : layers) names += (names.empty() ? "" : ", ") + layer.name;
  return names;
}

/// The inputs of all layers; what is wrong with any of them is told of together.
[[nodiscard]] std::vector<Inputs> openAll(const std::vector<Layer>& layers) {
  std::vector<Inputs> inputs;
  std::vector<std::string> faults;
  for (const Layer& layer : layers) {
    try {
      inLayer(layer.name, [&] {
        validate(layer.options);
        inputs.push_back(openInputs(layer.options, Observer{}));
      });
    } catch (const UsageError&) {
      throw;
    } catch (const Faults& several) {
      faults.insert(faults.end(), several.lines().begin(), several.lines().end());
    } catch (const Error& one) {
      faults.emplace_back(one.what());
    }
  }
  if (!faults.empty()) throw Faults(faults);
  return inputs;
}

/// @throws Error unless the frames of all layers have one size.
void requireOneSize(const std::vector<Layer>& layers, const std::vector<Inputs>& inputs) {
  for (std::size_t i = 1; i < layers.size(); ++i) {
    const Size size = inputs[i].target.scaled;
    const Size first = inputs.front().target.scaled;
    if (size == first) continue;
    throw Error("layer " + layers[i].name + ": --target-path " + layers[i].options.target.path +
                ": frames of " + sizeText(size) + ", but those of layer " + layers.front().name +
                " are " + sizeText(first) +
                "; wanted masks of one size (--target-scale changes it)");
  }
}

}  // namespace

LayerInputs openLayers(const LayeredShot& shot) {
  if (shot.layers.empty()) throw UsageError("a shot without layers: wanted one at least");
  LayerInputs layers;
  layers.inputs = openAll(shot.layers);
  requireOneSize(shot.layers, layers.inputs);
  for (std::size_t i = 0; i < shot.layers.size(); ++i) {
    layers.frames.push_back({shot.layers[i].name, layers.inputs[i].target.files.numbers});
  }
  layers.numbers = shotFrames(layers.frames);
  layers.size = layers.inputs.front().target.scaled;
  if (shot.background && !layerOfBackground(shot)) {
    layers.background = openBackground("--background", *shot.background);
  }
  return layers;
}

std::optional<std::size_t> layerOfBackground(const LayeredShot& shot) {
  if (!shot.background) return std::nullopt;
  const std::string exemplar = kExemplarSurface;
  if (*shot.background == exemplar) return 0;
  if (shot.background->compare(0, exemplar.size() + 1, exemplar + ":") != 0) return std::nullopt;
  const std::string name = shot.background->substr(exemplar.size() + 1);
  const auto found = std::find_if(shot.layers.begin(), shot.layers.end(),
                                  [&](const Layer& layer) { return layer.name == name; });
  if (found != shot.layers.end()) return static_cast<std::size_t>(found - shot.layers.begin());
  throw UsageError("--background " + *shot.background + ": there is no such layer; wanted " +
                   exemplar + ":NAME with one of " + namesOf(shot.layers));
}

Image<Rgba> bottomOf(const LayeredShot& shot, const LayerInputs& layers,
                     const std::function<void()>& beforeFile) {
  Image<Rgba> bottom(layers.size, Rgba{0.0F, 0.0F, 0.0F, 0.0F});
  if (!shot.background) return bottom;
  const std::optional<std::size_t> film = layerOfBackground(shot);
  Inputs noFilm;
  noFilm.background = layers.background;
  const Image<Rgb> picture =
      backdrop("--background", film ? kExemplarSurface : *shot.background,
               film ? layers.inputs[*film] : noFilm, layers.size, beforeFile);
  std::transform(picture.begin(), picture.end(), bottom.begin(), [](Rgb color) {
    return Rgba{color.r, color.g, color.b, 1.0F};
  });
  return bottom;
}

}  // namespace fluidymation

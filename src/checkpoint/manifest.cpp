#include "checkpoint/manifest.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "checkpoint/checkpoint_file.h"
#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order, so that equal manifests have equal bytes
using SortedJson = nlohmann::json;    // for what others wrote: finds names among many, too

constexpr const char* kProgram = "fluidymation";
constexpr int kFormat = 1;
constexpr std::int64_t kMostBytes = 256 << 20;

[[nodiscard]] std::vector<std::uint8_t> bytesOf(const Json& json) {
  const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  return {text.begin(), text.end()};
}

[[nodiscard]] Json objectOf(const std::vector<std::pair<std::string, std::string>>& values) {
  Json object = Json::object();
  for (const auto& [name, value] : values) object[name] = value;
  return object;
}

[[nodiscard]] std::vector<std::pair<std::string, std::string>> valuesOf(const SortedJson& object) {
  std::vector<std::pair<std::string, std::string>> values;
  for (const auto& [name, value] : object.items()) {
    values.emplace_back(name, value.get<std::string>());
  }
  return values;
}

[[nodiscard]] Digest digestIn(const SortedJson& text) {
  const std::optional<Digest> digest = Digest::parse(text.get<std::string>());
  if (!digest) throw Error("holds a digest that is none");
  return *digest;
}

[[nodiscard]] int numberIn(const std::string& text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, number);
  if (failure != std::errc{} || stop != end) throw Error("holds a frame number that is none");
  return number;
}

void sortByNumber(InputDigests& input) {
  std::sort(input.files.begin(), input.files.end(),
            [](const auto& a, const auto& b) { return a.number < b.number; });
}

/// A name and no way to elsewhere.
[[nodiscard]] std::string fileNameIn(const SortedJson& text) {
  auto name = text.get<std::string>();
  if (name.empty() || name == "." || name == ".." ||
      name.find_first_of(std::string("/\0", 2)) != std::string::npos) {
    throw Error("holds a file name that is none");
  }
  return name;
}

[[nodiscard]] Manifest manifestIn(const SortedJson& json) {
  if (!json.is_object() || json.value("program", "") != kProgram) {
    throw Error("is no manifest of fluidymation");
  }
  if (const auto format = json.at("format").get<std::int64_t>(); format != kFormat) {
    throw Error("has format " + std::to_string(format) + "; wanted " + std::to_string(kFormat));
  }
  Manifest manifest;
  manifest.fingerprint.version = json.at("version").get<std::string>();
  manifest.complete = json.at("complete").get<bool>();
  manifest.paths = valuesOf(json.at("paths"));
  manifest.fingerprint.options = valuesOf(json.at("options"));
  for (const auto& [option, files] : json.at("inputs").items()) {
    InputDigests input{option, {}};
    for (const auto& [number, digest] : files.items()) {
      input.files.push_back({numberIn(number), digestIn(digest)});
    }
    sortByNumber(input);
    manifest.fingerprint.inputs.push_back(std::move(input));
  }
  for (const SortedJson& frame : json.at("frames")) {
    manifest.frames.push_back({frame.at("number").get<int>(), fileNameIn(frame.at("file")),
                               digestIn(frame.at("xxh128"))});
  }
  return manifest;
}

}  // namespace

std::vector<std::uint8_t> encode(const Manifest& manifest) {
  Json json;
  json["program"] = kProgram;
  json["version"] = manifest.fingerprint.version;
  json["format"] = kFormat;
  json["complete"] = manifest.complete;
  json["paths"] = objectOf(manifest.paths);
  json["options"] = objectOf(manifest.fingerprint.options);
  Json& inputs = json["inputs"] = Json::object();
  for (const InputDigests& input : manifest.fingerprint.inputs) {
    // Pair by pair: looking for each name among all before it would take the square of their
    // number.
    Json::object_t files;
    for (const InputDigests::File& file : input.files) {
      files.push_back({std::to_string(file.number), file.digest.text()});
    }
    inputs[input.option] = std::move(files);
  }
  Json& frames = json["frames"] = Json::array();
  for (const Manifest::Frame& frame : manifest.frames) {
    frames.push_back(
        {{"number", frame.number}, {"file", frame.file}, {"xxh128", frame.digest.text()}});
  }
  return bytesOf(json);
}

Manifest readManifest(const std::string& path) {
  const std::vector<std::uint8_t> bytes = readWhole(path, kMostBytes, "a manifest of fluidymation");
  try {
    return manifestIn(SortedJson::parse(bytes.begin(), bytes.end()));
  } catch (const SortedJson::exception&) {
    throw Error(path + ": is damaged, or no manifest of fluidymation");
  } catch (const Error& error) {
    throw Error(path + ": " + error.what());
  }
}

bool isOf(const Manifest& manifest, Fingerprint fingerprint) {
  for (InputDigests& input : fingerprint.inputs) sortByNumber(input);
  return !difference(manifest.fingerprint, fingerprint);
}

std::vector<std::uint8_t> encodeTimes(const FrameRecords& frames, const std::vector<int>& numbers) {
  constexpr double kSteps = 1000.0;  // milliseconds
  Json seconds = Json::array();
  for (std::size_t j = 0; j < frames.size(); ++j) {
    if (!frames[j]) continue;
    seconds.push_back(
        {{"number", numbers[j]}, {"seconds", std::round(kSteps * frames[j]->seconds) / kSteps}});
  }
  return bytesOf(Json{{"program", kProgram}, {"frames", std::move(seconds)}});
}

}  // namespace fluidymation

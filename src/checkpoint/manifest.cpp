#include "checkpoint/manifest.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "checkpoint/checkpoint_file.h"
#include "checkpoint/percent_encoding.h"
#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order, so that equal manifests have equal bytes
using SortedJson = nlohmann::json;    // for what others wrote: finds names among many, too

constexpr const char* kProgram = "fluidymation";
constexpr int kFormat = 1;

/// No manifest is larger, with names of 255 bytes.
constexpr std::int64_t kFileBytes = 64;     // number, digest, and what JSON puts round them
constexpr std::int64_t kFrameBytes = 900;   // likewise, and a name; "%FF" takes three bytes
constexpr std::int64_t kTextBytes = 16384;  // name and value: a path of 4000 bytes, each as "%FF"
constexpr std::int64_t kMostBytes =
    (kFrameBytes + kFileBytes * static_cast<std::int64_t>(kMostInputs)) *
        static_cast<std::int64_t>(kMostFrames) +
    kTextBytes * static_cast<std::int64_t>(kMostOptions + 2 * kMostInputs);

[[nodiscard]] std::vector<std::uint8_t> bytesOf(const Json& json) {
  const std::string text = json.dump(1, ' ') + "\n";
  return {text.begin(), text.end()};
}

/// JSON's texts are UTF-8, names of files are any bytes. Those that are no UTF-8 become an object
/// of this one member, whose value has "%FF" for a byte that is no letter, digit or one of ".-_/".
constexpr const char* kPercentEncoded = "percent-encoded";

[[nodiscard]] Json jsonOf(const std::string& text) {
  Json json = text;
  try {
    (void)json.dump();  // throws where it is no UTF-8
  } catch (const Json::type_error&) {
    json = {{kPercentEncoded, percentEncoded(text)}};
  }
  return json;
}

[[nodiscard]] std::string textIn(const SortedJson& json) {
  if (!json.is_object()) return json.get<std::string>();
  const std::optional<std::string> text =
      percentDecoded(json.at(kPercentEncoded).get<std::string>());
  if (!text) throw Error("holds a text that is badly encoded");
  return *text;
}

[[nodiscard]] Json objectOf(const std::vector<std::pair<std::string, std::string>>& values) {
  Json object = Json::object();
  for (const auto& [name, value] : values) object[name] = jsonOf(value);
  return object;
}

/// `items` of null or of a number would be taken for those of nothing.
[[nodiscard]] const SortedJson& requiredObject(const SortedJson& json) {
  if (!json.is_object()) throw Error("is damaged, or no manifest of fluidymation");
  return json;
}

[[nodiscard]] std::vector<std::pair<std::string, std::string>> valuesOf(const SortedJson& object) {
  std::vector<std::pair<std::string, std::string>> values;
  for (const auto& [name, value] : requiredObject(object).items()) {
    values.emplace_back(name, textIn(value));
  }
  return values;
}

[[nodiscard]] Digest digestIn(const SortedJson& text) {
  const std::optional<Digest> digest = Digest::parse(text.get<std::string>());
  if (!digest) throw Error("holds a digest that is none");
  return *digest;
}

[[nodiscard]] int numberOf(const std::string& text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, number);
  // Only one spelling, so that no frame comes twice: "07" is none.
  if (failure != std::errc{} || stop != end || std::to_string(number) != text) {
    throw Error("holds a frame number that is none");
  }
  return number;
}

/// Written so that no number wraps, and none with a fraction passes.
[[nodiscard]] int numberIn(const SortedJson& json) {
  constexpr std::int64_t kLeast = std::numeric_limits<int>::min();
  constexpr std::int64_t kMost = std::numeric_limits<int>::max();
  const bool fits = json.is_number_unsigned()
                        ? json.get<std::uint64_t>() <= static_cast<std::uint64_t>(kMost)
                        : json.is_number_integer() && json.get<std::int64_t>() >= kLeast &&
                              json.get<std::int64_t>() <= kMost;
  if (!fits) throw Error("holds a number that is none, or out of range");
  return json.get<int>();
}

void sortByNumber(InputDigests& input) {
  std::sort(input.files.begin(), input.files.end(),
            [](const auto& a, const auto& b) { return a.number < b.number; });
}

/// A name and no way to elsewhere.
[[nodiscard]] std::string fileNameIn(const SortedJson& text) {
  std::string name = textIn(text);
  if (name.empty() || name == "." || name == ".." ||
      name.find_first_of(std::string("/\0", 2)) != std::string::npos) {
    throw Error("holds a file name that is none");
  }
  return name;
}

/// @throws Error where a number or a file comes twice.
void requireOnce(const std::vector<Manifest::Frame>& frames) {
  std::set<int> numbers;
  std::set<std::string> files;
  for (const Manifest::Frame& frame : frames) {
    if (!numbers.insert(frame.number).second) {
      throw Error("tells of frame " + std::to_string(frame.number) + " twice");
    }
    if (!files.insert(frame.file).second) throw Error("tells of the file " + frame.file + " twice");
  }
}

[[nodiscard]] Manifest manifestIn(const SortedJson& json) {
  if (!json.is_object() || json.value("program", "") != kProgram) {
    throw Error("is no manifest of fluidymation");
  }
  if (const auto format = numberIn(json.at("format")); format != kFormat) {
    throw Error("has format " + std::to_string(format) + "; wanted " + std::to_string(kFormat));
  }
  Manifest manifest;
  manifest.fingerprint.version = json.at("version").get<std::string>();
  manifest.complete = json.at("complete").get<bool>();
  manifest.paths = valuesOf(json.at("paths"));
  manifest.fingerprint.options = valuesOf(json.at("options"));
  const SortedJson& inputs = requiredObject(json.at("inputs"));
  const SortedJson& frames = json.at("frames");
  if (!frames.is_array()) throw Error("is damaged, or no manifest of fluidymation");
  if (manifest.fingerprint.options.size() > kMostOptions || inputs.size() > kMostInputs ||
      frames.size() > kMostFrames) {
    throw Error("holds more than a run can have");
  }
  for (const auto& [option, files] : inputs.items()) {
    InputDigests input{option, {}};
    if (requiredObject(files).size() > kMostFrames) throw Error("holds more than a run can have");
    for (const auto& [number, digest] : files.items()) {
      input.files.push_back({numberOf(number), digestIn(digest)});
    }
    sortByNumber(input);
    manifest.fingerprint.inputs.push_back(std::move(input));
  }
  for (const SortedJson& frame : frames) {
    manifest.frames.push_back(
        {numberIn(frame.at("number")), fileNameIn(frame.at("file")), digestIn(frame.at("xxh128"))});
  }
  requireOnce(manifest.frames);
  return manifest;
}

[[nodiscard]] Manifest parsed(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  try {
    return manifestIn(SortedJson::parse(bytes.begin(), bytes.end()));
  } catch (const SortedJson::exception&) {
    throw Error(path + ": is damaged, or no manifest of fluidymation");
  } catch (const Error& error) {
    throw Error(path + ": " + error.what());
  }
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
        {{"number", frame.number}, {"file", jsonOf(frame.file)}, {"xxh128", frame.digest.text()}});
  }
  return bytesOf(json);
}

Manifest readManifest(const std::string& path) {
  try {
    const std::vector<std::uint8_t> bytes =
        readWhole(path, kMostBytes, "a manifest of fluidymation");
    return parsed(path, bytes);
  } catch (const std::bad_alloc&) {
    throw Error(path + ": is too large for the memory");
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

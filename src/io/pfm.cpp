#include "fluidymation/io/pfm.h"

#include "fluidymation/io/atomic_file.h"
#include "io/little_endian.h"

namespace fluidymation {
namespace {

void appendSample(std::vector<std::uint8_t>& bytes, float sample) {
  appendLittleEndian(bytes, sample);
}

void appendSample(std::vector<std::uint8_t>& bytes, const Float3& sample) {
  appendLittleEndian(bytes, sample.x);
  appendLittleEndian(bytes, sample.y);
  appendLittleEndian(bytes, sample.z);
}

template <typename T>
void writeMap(const std::string& path, const Image<T>& image, const std::string& magic) {
  writeAtomically(path, [&](const ByteSink& sink) {
    // Scale -1.0: the sign means little endian.
    const std::string header = magic + "\n" + std::to_string(image.width()) + " " +
                               std::to_string(image.height()) + "\n-1.0\n";
    sink(header.data(), header.size());
    std::vector<std::uint8_t> bytes;
    for (int y = image.height() - 1; y >= 0; --y) {
      bytes.clear();
      for (int x = 0; x < image.width(); ++x) appendSample(bytes, image(x, y));
      sink(bytes.data(), bytes.size());
    }
  });
}

}  // namespace

void writePfm(const std::string& path, const Image<float>& image) { writeMap(path, image, "Pf"); }
void writePfm(const std::string& path, const Image<Float3>& image) { writeMap(path, image, "PF"); }

}  // namespace fluidymation

#include "fluidymation/io/flow_file.h"

#include "fluidymation/io/atomic_file.h"
#include "io/little_endian.h"

namespace fluidymation {

void writeFlow(const std::string& path, const Image<Vec2>& flow) {
  writeAtomically(path, [&](const ByteSink& sink) {
    std::vector<std::uint8_t> bytes = {'P', 'I', 'E', 'H'};
    appendLittleEndian(bytes, static_cast<std::uint32_t>(flow.width()));
    appendLittleEndian(bytes, static_cast<std::uint32_t>(flow.height()));
    sink(bytes.data(), bytes.size());
    for (int y = 0; y < flow.height(); ++y) {
      bytes.clear();
      for (int x = 0; x < flow.width(); ++x) {
        appendLittleEndian(bytes, flow(x, y).x);
        appendLittleEndian(bytes, flow(x, y).y);
      }
      sink(bytes.data(), bytes.size());
    }
  });
}

}  // namespace fluidymation

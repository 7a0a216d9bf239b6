#include "cli/streams.h"

#include "fluidymation/core/error.h"

namespace fluidymation::cli {

void requireWritten(const Streams& streams) {
  streams.out << std::flush;
  if (!streams.out.good()) throw Error("standard output cannot be written");
}

}  // namespace fluidymation::cli

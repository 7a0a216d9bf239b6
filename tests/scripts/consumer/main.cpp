// Uses every room of the engine that has public headers, so that none of them wants what is not
// installed.

#include <fluidymation/automatic.h>
#include <fluidymation/core/error.h>
#include <fluidymation/core/version.h>
#include <fluidymation/guides/guide_stream.h>
#include <fluidymation/io/png.h>
#include <fluidymation/option_ranges.h>
#include <fluidymation/pipeline.h>
#include <fluidymation/presets.h>
#include <fluidymation/synthesis/synthesizer.h>
#include <fluidymation/verify.h>

#include <iostream>

int main() {
  fluidymation::Options options;
  options.source.path = "nowhere/%d.png";
  options.sourceMaskPath = "nowhere/m%d.png";
  options.target.path = "nowhere/t%d.png";
  options.outPath = "nowhere/out/%d.png";
  try {
    fluidymation::stylize(options, {});
  } catch (const fluidymation::Error& error) {
    std::cout << fluidymation::version() << ": " << error.what() << "\n";
    return 0;
  }
  return 1;
}

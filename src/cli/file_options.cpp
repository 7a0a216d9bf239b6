#include <optional>
#include <string>

#include "cli/table_builder.h"

namespace fluidymation::cli {

void addFiles(Table& table) {
  table.pattern("--src-path", "exemplar frames, PNG, e.g. leaf/rgb/%05d.png", "thesis §3.1",
                [](CommandLine& c) -> std::string& { return c.options.source.path; });
  table.pattern("--src-mask-path", "masks of the exemplar, numbered as --src-path", "thesis §3.1",
                [](CommandLine& c) -> std::string& { return c.options.sourceMaskPath; });
  table.pattern("--target-path", "masks of the animation to paint", "thesis §3.1",
                [](CommandLine& c) -> std::string& { return c.options.target.path; });
  table.pattern(
      "--out-path", "painted frames to write, PNG, numbered as --target-path", "thesis §3.1",
      [](CommandLine& c) -> std::string& { return c.options.outPath; }, checkOutputPath);
  table.optionalPattern("--src-flow-path",
                        "the exemplar's motion, .flo or KITTI PNG, not derived from\n"
                        "masks; unknown vectors count as 0: fill holes before",
                        "paper §3", [](CommandLine& c) -> std::optional<std::string>& {
                          return c.options.sourceFlowPath;
                        });
  table.optionalPattern(
      "--target-flow-path", "the same for the animation", "paper §3",
      [](CommandLine& c) -> std::optional<std::string>& { return c.options.targetFlowPath; });
  table.word<FlowConvention>(
      "--flow-convention", kFilesGroup,
      "file n is seen on frame n; backward: how it came from n-1;\n"
      "forward: how it goes on to n+1",
      {{"backward", FlowConvention::kBackward}, {"forward", FlowConvention::kForward}},
      "not in the thesis",
      [](CommandLine& c) -> FlowConvention& { return c.options.flowConvention; });
  table.integer("--compression-level", kFilesGroup,
                "of the painted frames; 0 is fastest, 9 smallest: all have the\nsame pixels", "",
                ranges::kCompressionLevels, "not in the thesis",
                [](CommandLine& c) -> int& { return c.options.compressionLevel; });
  table.word<BitDepth>("--bit-depth", kFilesGroup, "of each channel of the painted frames",
                       {{"8", BitDepth::k8}, {"16", BitDepth::k16}}, "not in the thesis",
                       [](CommandLine& c) -> BitDepth& { return c.options.bitDepth; });
  table.add(
      {"--background", kFilesGroup, "COLOR|FILE|exemplar",
       "paint opaque frames, laid over #RRGGBB, white, black, gray, a\nPNG file, or the "
       "film's bare surface, its masks filled in\n(default off: transparent; not in the thesis)",
       false,
       [](CommandLine& line, const std::string& value) {
         if (value.empty()) {
           throw UsageError(shown("--background", value) + ": wanted a colour, a file or exemplar");
         }
         line.options.background = value;
       },
       [](const CommandLine& line) { return line.options.background; }});
  table.add({"--dump-guides", kFilesGroup, "DIR",
             "write masks, guides and matches to DIR/source, DIR/target\n(default off; not in the "
             "thesis)",
             false,
             [](CommandLine& line, const std::string& value) {
               if (value.empty()) {
                 throw UsageError(shown("--dump-guides", value) + ": wanted a folder's name");
               }
               line.options.dumpGuidesDirectory = value;
             },
             [](const CommandLine& line) { return line.options.dumpGuidesDirectory; }});
}

}  // namespace fluidymation::cli

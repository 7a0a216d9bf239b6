#include <string>

#include "cli/table_builder.h"

namespace fluidymation::cli {
namespace {

constexpr const char* kPreviewGroup = "Preview";

}  // namespace

void addPreview(Table& table) {
  table.add({"--preview", kPreviewGroup, "FILE",
             "show the frames, when all are painted, as a sheet of some\n"
             "(.png), or as a film (.apng; .gif and .mp4 by ffmpeg)\n(default off)",
             false,
             [](CommandLine& line, const std::string& value) {
               if (value.empty()) {
                 throw UsageError(shown("--preview", value) + ": wanted a file's name");
               }
               line.preview.path = value;
             },
             [](const CommandLine& line) {
               return line.preview.path.empty() ? Table::Text() : line.preview.path;
             }});
  table.add({"--preview-background", kPreviewGroup, "COLOR|FILE|exemplar",
             std::string("what they are laid over: #RRGGBB, white, black, gray, a PNG\n"
                         "file, or the film's bare surface, its masks filled in\n(default ") +
                 kDefaultBackground + ")",
             false,
             [](CommandLine& line, const std::string& value) {
               if (value.empty()) {
                 throw UsageError(shown("--preview-background", value) +
                                  ": wanted a colour, a file or exemplar");
               }
               line.preview.background = value;
             },
             [](const CommandLine& line) { return line.preview.background; }});
  table.add({"--preview-beside", kPreviewGroup, "",
             "film and masks beside the frames\n(default off)", false,
             [](CommandLine& line, const std::string&) { line.preview.beside = true; },
             [](const CommandLine& line) { return flagText(line.preview.beside); }});
  table.add({"--preview-every", kPreviewGroup, "N",
             "also while painting, after every so many frames, with up to " +
                 std::to_string(Preview::kMostWhileRunning) + "\nof them\n(default off; in " +
                 ranges::kPreviewFrames.text() + ")",
             false,
             [](CommandLine& line, const std::string& value) {
               line.preview.every = parseInt("--preview-every", value, ranges::kPreviewFrames);
             },
             [](const CommandLine& line) {
               return line.preview.every ? Table::Text(std::to_string(*line.preview.every))
                                         : Table::Text();
             }});
}

}  // namespace fluidymation::cli

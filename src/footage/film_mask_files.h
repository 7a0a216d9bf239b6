#pragma once

#include <string>
#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/film_masks.h"
#include "fluidymation/io/frame_sequence.h"

namespace fluidymation {

/// What is read and written, one path a frame.
struct FilmMaskFiles {
  FrameFiles film;
  Size size;
  std::vector<std::string> masks;
  std::vector<std::string> mattes;  ///< empty where none are wanted
};

/// Checks the options, finds the film, and makes sure that it fits into memory and that nothing
/// that is written replaces what is read or another output. Changes nothing on the disk.
/// @throws UsageError, Error naming option or file.
[[nodiscard]] FilmMaskFiles openFilm(const FilmMaskOptions& options);

/// Creates the folders of all that is written. @throws Error naming folder or file.
void createFolders(const FilmMaskOptions& options);

}  // namespace fluidymation

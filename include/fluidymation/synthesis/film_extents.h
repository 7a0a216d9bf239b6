#pragma once

#include <cstddef>

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/channels.h"

namespace fluidymation {

/// Finds how the motion extents of a film are scaled from the guides of all its frames, one after
/// the other: the film need not be held for it.
class FilmExtents {
 public:
  /// The next frame; all hold ages or none does.
  void add(const GuideFrame& guides);

  /// The scale of the frames added: of their ages where they hold such; else by `unit`. Where
  /// nothing ever moves there is no mean to go by, and the scale is that of pixels.
  [[nodiscard]] ExtentScale scale(ExtentUnit unit) const;

 private:
  /// Mean length of acc+ and acc- over all mask pixels, px; 0 when nothing ever moves.
  [[nodiscard]] float meanPx() const;

  int frames_ = 0;
  bool haveAges_ = false;
  double sumPx_ = 0.0;
  std::size_t count_ = 0;
};

}  // namespace fluidymation

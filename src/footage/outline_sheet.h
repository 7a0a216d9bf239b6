#pragma once

#include <string>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// Frames of a film with the outlines of their masks, small, in rows.
class OutlineSheet {
 public:
  static constexpr int kMostFrames = 12;

  /// @param frameCount  of the film; `kMostFrames` of them are shown, evenly chosen.
  explicit OutlineSheet(int frameCount);

  /// @param frame  from 0; frames that are not shown are passed over.
  void add(int frame, const Image<Rgb>& picture, const Mask& mask);

  /// @throws Error naming the file. Some frame must have been added (asserted).
  void write(const std::string& path) const;

 private:
  std::vector<int> shown_;
  std::vector<Image<Rgb>> cells_;
};

}  // namespace fluidymation

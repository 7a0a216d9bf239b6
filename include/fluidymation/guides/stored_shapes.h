#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/guides/input_mask.h"
#include "fluidymation/guides/packed_shape.h"
#include "fluidymation/io/record_store.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// The smoothed shapes of a sequence, which wait in a store; only what is asked of all of them at a
/// time is kept here.
class StoredShapes {
 public:
  /// Reads and smooths all masks of a sequence, one at a time; they must have one size (asserted).
  /// A sequence is soft when any of its masks is; then all of them keep their sub-pixel outline.
  /// Otherwise all are cut at one half before they are smoothed.
  /// @param readMask  asked for each frame, in order; where a later mask than the first turns out
  ///   to be soft, from the first one on once more.
  /// @param store  must outlive this.
  /// @throws Error when the store cannot be written; whatever `readMask` throws.
  StoredShapes(int frameCount, const MaskReader& readMask, const MaskOptions& options,
               RecordStore& store);

  [[nodiscard]] int frameCount() const { return static_cast<int>(frames_.size()); }

  /// @throws Error when the store cannot be read.
  [[nodiscard]] PackedShape shape(int frame) const;

  /// Mask pixels of a frame.
  [[nodiscard]] std::size_t pixelCount(int frame) const { return of(frame).pixelCount; }
  /// The smallest box that holds all of them.
  [[nodiscard]] Box box(int frame) const { return of(frame).box; }
  /// Whether a frame is neither empty nor full.
  [[nodiscard]] bool hasEdge(int frame) const;
  /// Whether a frame has the shape of the one before it; false for the first one, and beyond the
  /// last one.
  [[nodiscard]] bool repeats(int frame) const;

  [[nodiscard]] Size size() const { return size_; }

  /// Forgets a shape that is not asked for again, but for what is kept of it here. Shapes are to be
  /// dropped in order.
  void drop(int frame);

 private:
  struct Stored {
    RecordStore::Record mask = 0;
    std::optional<RecordStore::Record> outline;  ///< of a soft shape
    Box box;
    std::size_t pixelCount = 0;
    bool repeats = false;  ///< and shares the records of the frame before
  };

  [[nodiscard]] const Stored& of(int frame) const;
  /// Reads all masks as hard or soft ones. @return false where a soft one came among hard ones.
  bool readAll(int frameCount, const MaskReader& readMask, const MaskOptions& options, bool soft);
  [[nodiscard]] Stored stored(const PackedShape& shape);

  RecordStore& store_;
  Size size_;
  std::vector<Stored> frames_;
};

}  // namespace fluidymation

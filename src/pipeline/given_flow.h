#pragma once

#include <string>

#include "fluidymation/core/image.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// Finds the flow files of a sequence of masks and reads their headers.
///
/// Frame i has to know the movement from frame i - 1 to it. Its own file says so where a file looks
/// back along the sequence: backward files played forwards, forward files played backwards. Else
/// the file of the frame before does, seen on that frame. Played backwards, a movement is negated.
/// Either way one file at an end of the sequence is not needed.
/// @param option  the option that gave `path`, for messages.
/// @throws Error naming the files that are missing, damaged or of another size than the masks.
[[nodiscard]] FlowSequence openFlowSequence(const std::string& path, const std::string& option,
                                            FlowConvention convention,
                                            const SequenceOptions& sequence,
                                            const InputSequence& masks);

/// Reads the flow of frame after frame: a FlowReader.
class GivenFlow {
 public:
  /// @param sequence  must outlive the reader.
  explicit GivenFlow(const FlowSequence& sequence) : sequence_(sequence) {}

  /// The movement from the frame before to `frame`, px of the scaled frames; that of the first
  /// frame is the movement to the second one where its own file is not needed and not there.
  /// A movement seen on the frame before is taken from the same pixel; where that was not in the
  /// mask then, the movement to the frame after stands in, if there is a file of it.
  /// @throws Error naming the file.
  [[nodiscard]] Image<Vec2> flow(int frame, const Mask& previousMask);

 private:
  [[nodiscard]] bool has(int frame) const;
  /// The scaled content of the frame's file.
  [[nodiscard]] Image<Vec2> read(int frame) const;

  const FlowSequence& sequence_;
  Image<Vec2> last_;  ///< of the frame before, where that file is wanted twice
};

}  // namespace fluidymation

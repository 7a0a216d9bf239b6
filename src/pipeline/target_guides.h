#pragma once

#include <functional>
#include <optional>

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/guides/guide_stream.h"

namespace fluidymation {

/// Gives the guides of the target's frames, one after the other.
struct GuideSource {
  std::function<GuidePart()> next;
  /// Passes over the next frames, whose guides nobody wants; those of the frames after them stay
  /// what they are. `beforeEach` as that of `passOver`.
  std::function<void(int count, const std::function<void()>& beforeEach)> skip;
};

/// Guides with the frames' ages where these are compared.
/// @param guides    must outlive the source.
/// @param marginPx  how far round the shapes they are wanted; none: of whole frames.
[[nodiscard]] GuideSource targetGuides(GuideStream& guides, std::optional<int> marginPx,
                                       bool withAges);

/// Passes over the first `count` frames, which are painted already.
/// @param wantsLast   whether the guides of the last of these are wanted, to go on from a state.
/// @param beforeEach  called before each frame that is gone through, see `GuideStream::skip`; what
///   it throws ends the run.
/// @return  these, else no guides.
[[nodiscard]] GuidePart passOver(int count, bool wantsLast, const GuideSource& guides,
                                 const std::function<void()>& beforeEach);

}  // namespace fluidymation

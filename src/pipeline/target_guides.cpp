#include "pipeline/target_guides.h"

#include <memory>
#include <utility>

#include "fluidymation/guides/material_age.h"

namespace fluidymation {

GuideSource targetGuides(GuideStream& guides, std::optional<int> marginPx, bool withAges) {
  const auto nextPart = [&guides, marginPx]() -> GuidePart {
    if (marginPx) return guides.nextPart(*marginPx);
    GuideFrame frame = guides.next();
    const FramePart whole = FramePart::whole(frame.mask.size());
    return {whole, std::move(frame)};
  };
  GuideSource source;
  if (!withAges) {
    source.next = nextPart;
    source.skip = [&guides](int count, const std::function<void()>& beforeEach) {
      guides.skip(count, beforeEach);
    };
    return source;
  }
  const auto ages = std::make_shared<TargetAges>();
  source.next = [nextPart, ages] {
    GuidePart frame = nextPart();
    frame.guides.age = ages->next(frame.guides.mask, frame.part.box);
    frame.guides.ageGrows = ages->haveGrown();
    return frame;
  };
  source.skip = [&guides, ages](int count, const std::function<void()>& beforeEach) {
    guides.skip(count, beforeEach, [&ages](const Mask& mask) { (void)ages->next(mask); });
  };
  return source;
}

GuidePart passOver(int count, bool wantsLast, const GuideSource& guides,
                   const std::function<void()>& beforeEach) {
  const bool givesLast = wantsLast && count > 0;
  guides.skip(givesLast ? count - 1 : count, beforeEach);
  if (!givesLast) return {};
  beforeEach();
  return guides.next();
}

}  // namespace fluidymation

#include "pipeline/target_guides.h"

#include <memory>

#include "fluidymation/guides/material_age.h"

namespace fluidymation {

GuideSource targetGuides(GuideStream& guides, bool withAges) {
  GuideSource source;
  if (!withAges) {
    source.next = [&guides] { return guides.next(); };
    source.skip = [&guides](int count, const std::function<void()>& beforeEach) {
      guides.skip(count, beforeEach);
    };
    return source;
  }
  const auto ages = std::make_shared<TargetAges>();
  source.next = [&guides, ages] {
    GuideFrame frame = guides.next();
    frame.age = ages->next(frame.mask);
    frame.ageGrows = ages->haveGrown();
    return frame;
  };
  source.skip = [&guides, ages](int count, const std::function<void()>& beforeEach) {
    guides.skip(count, beforeEach, [&ages](const Mask& mask) { (void)ages->next(mask); });
  };
  return source;
}

GuideFrame passOver(int count, bool wantsLast, const GuideSource& guides,
                    const std::function<void()>& beforeEach) {
  const bool givesLast = wantsLast && count > 0;
  guides.skip(givesLast ? count - 1 : count, beforeEach);
  if (!givesLast) return {};
  beforeEach();
  return guides.next();
}

}  // namespace fluidymation

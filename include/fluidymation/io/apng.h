#pragma once

#include <functional>
#include <string>

#include "fluidymation/core/image.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

/// Writes an animated PNG file that repeats for ever (PNG Specification, Third Edition, §11.3.6:
/// acTL, fcTL, fdAT); what does not know animations shows its first picture. One picture is in
/// memory at a time. Written atomically.
/// @param frameCount  at least 1.
/// @param frame  gives picture i; called once for each, in order. All have one size (asserted).
/// @throws Error naming the file; whatever `frame` throws.
void writeAnimatedPng(const std::string& path, int frameCount, int framesPerSecond,
                      const std::function<Image<Rgba8>(int frame)>& frame);

}  // namespace fluidymation

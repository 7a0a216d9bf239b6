#pragma once

#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// The size of `size` with no side longer than `longest`, and even sides where video wants them.
[[nodiscard]] Size fitted(Size size, int longest);

/// Pictures of one height next to each other.
[[nodiscard]] Image<Rgb> besideEachOther(const std::vector<Image<Rgb>>& pictures);

/// Pictures of one size in rows, four in each.
[[nodiscard]] Image<Rgb> inRows(const std::vector<Image<Rgb>>& pictures);

/// `most` of `count` things, evenly chosen, first and last among them; all where there are no more.
[[nodiscard]] std::vector<int> evenly(int count, int most);

}  // namespace fluidymation

#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "fluidymation/core/index.h"

namespace fluidymation {

/// Sets of the numbers 0..count-1 that grow together, each alone at first.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(at(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The smallest member of i's set.
  [[nodiscard]] int find(int i) {
    while (parent_[at(i)] != i) {
      parent_[at(i)] = parent_[at(parent_[at(i)])];
      i = parent_[at(i)];
    }
    return i;
  }

  void join(int i, int j) {
    const int a = find(i);
    const int b = find(j);
    parent_[at(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace fluidymation

#include "fluidymation/synthesis/nnf_scaling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// Bins round the circle in which angles count as equal when matches are counted.
constexpr int kAngleBins = 32;

/// Bin of an angle, rounded to the nearest: found in the half quadrant from 0 to 45 degrees, and
/// reflected back.
int angleBin(const Rotation& rotation) {
  // tan of 1/2, 3/2, 5/2 and 7/2 of a bin
  constexpr std::array<float, kAngleBins / 8> kBounds{0.09849140F, 0.30334668F, 0.53451114F,
                                                      0.82067879F};
  const float across = std::abs(rotation.cosine);
  const float along = std::abs(rotation.sine);
  const float large = std::max(across, along);
  const float small = std::min(across, along);
  int bin = 0;
  for (const float bound : kBounds) bin += small > bound * large ? 1 : 0;
  if (along > across) bin = kAngleBins / 4 - bin;
  if (rotation.cosine < 0.0F) bin = kAngleBins / 2 - bin;
  if (rotation.sine < 0.0F) bin = kAngleBins - bin;
  return bin % kAngleBins;
}

/// `angleBin` of one rotation after the other: neighbouring matches mostly have the same one.
class AngleBins {
 public:
  [[nodiscard]] int operator()(const Rotation& rotation) {
    if (rotation.cosine != last_.cosine || rotation.sine != last_.sine) {
      last_ = rotation;
      bin_ = angleBin(rotation);
    }
    return bin_;
  }

 private:
  Rotation last_;
  int bin_ = angleBin(Rotation{});
};

/// What makes two matches of a block equal.
using Choice = std::uint64_t;

Choice choiceOf(const Match& match, AngleBins& bins) {
  constexpr unsigned kCoordinateBits = 19;  // more than the pyramid's pixels
  constexpr unsigned kAngleBits = 5;
  static_assert(1 << kAngleBits == kAngleBins);
  constexpr Choice kCoordinate = (Choice{1} << kCoordinateBits) - 1;
  const auto x = static_cast<Choice>(static_cast<std::int64_t>(match.nearestX())) & kCoordinate;
  const auto y = static_cast<Choice>(static_cast<std::int64_t>(match.nearestY())) & kCoordinate;
  return (((static_cast<Choice>(match.frame) << kCoordinateBits | y) << kCoordinateBits | x)
          << kAngleBits) |
         static_cast<Choice>(bins(match.rotation));
}

/// Counts the choices of a block.
class Election {
 public:
  /// @param members  of a block, at most.
  explicit Election(std::size_t members) {
    while (slots_.size() < 2 * members) slots_.resize(2 * slots_.size());
  }

  void vote(Choice choice) {
    // Most vote as the one before them
    Slot& slot = last_ != nullptr && last_->choice == choice ? *last_ : slotOf(choice);
    last_ = &slot;
    if (slot.votes == 0) {
      slot.choice = choice;
      slot.firstMember = members_;
      taken_.push_back(&slot);
    }
    ++slot.votes;
    ++members_;
  }

  /// The most frequent choice's first member, by its number in the order of votes; the one whose
  /// first member comes first wins ties. Begins anew.
  [[nodiscard]] std::size_t winner() {
    Slot best;
    for (Slot* slot : taken_) {  // in the order of their first members
      if (slot->votes > best.votes) best = *slot;
      *slot = Slot{};
    }
    taken_.clear();
    last_ = nullptr;
    members_ = 0;
    return best.firstMember;
  }

 private:
  struct Slot {
    Choice choice = 0;
    std::size_t votes = 0;  ///< 0: free
    std::size_t firstMember = 0;
  };

  /// The choice's slot, or the free one that it may take: a hash table with linear probing.
  Slot& slotOf(Choice choice) {
    constexpr Choice kFibonacci = 0x9E3779B97F4A7C15U;  // 2^64 / golden ratio
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = static_cast<std::size_t>((choice * kFibonacci) >> 32U) & mask;
    while (slots_[i].votes != 0 && slots_[i].choice != choice) i = (i + 1) & mask;
    return slots_[i];
  }

  std::vector<Slot> slots_ = std::vector<Slot>(2);  ///< a power of two of them
  std::vector<Slot*> taken_;
  Slot* last_ = nullptr;  ///< that of the last vote
  std::size_t members_ = 0;
};

}  // namespace

NearestNeighborField upscale(const NearestNeighborField& coarse, const Image<Segment>& fine) {
  NearestNeighborField nnf(fine.size());
  forEachRow(fine.height(), [&](int y) {
    for (int x = 0; x < fine.width(); ++x) {
      if (fine(x, y) == Segment::kOutside) continue;
      const Match& parent = coarse(x / 2, y / 2);
      if (!parent.exists()) continue;
      const Match doubled{2.0F * parent.x + 0.5F, 2.0F * parent.y + 0.5F, parent.frame,
                          parent.rotation};
      nnf(x, y) =
          doubled.moved({static_cast<float>(x % 2) - 0.5F, static_cast<float>(y % 2) - 0.5F});
    }
  });
  return nnf;
}

NearestNeighborField downscale(const NearestNeighborField& fine, int level) {
  if (level == 0) return fine.clone();
  const int block = 1 << level;
  const float centre = 0.5F * static_cast<float>(block - 1);
  const float scale = 1.0F / static_cast<float>(block);
  Size size = fine.size();
  for (int l = 0; l < level; ++l) size = halvedSize(size);

  NearestNeighborField coarse(size);
  parallelFor(size.height, 1, [&](int y) {
    std::vector<Match> matches;
    AngleBins bins;
    Election election(static_cast<std::size_t>(block) * static_cast<std::size_t>(block));
    for (int x = 0; x < size.width; ++x) {
      matches.clear();
      for (int by = 0; by < block && y * block + by < fine.height(); ++by) {
        for (int bx = 0; bx < block && x * block + bx < fine.width(); ++bx) {
          const Match& match = fine(x * block + bx, y * block + by);
          if (!match.exists()) continue;
          const Match middle =
              match.moved({centre - static_cast<float>(bx), centre - static_cast<float>(by)});
          const Match scaled{(middle.x - centre) * scale, (middle.y - centre) * scale, match.frame,
                             match.rotation};
          election.vote(choiceOf(scaled, bins));
          matches.push_back(scaled);
        }
      }
      if (!matches.empty()) coarse(x, y) = matches[election.winner()];
    }
  });
  return coarse;
}

}  // namespace fluidymation

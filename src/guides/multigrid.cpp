#include "multigrid.h"

#include <utility>

namespace fluidymation {
namespace {

constexpr int kSmoothings = 2;  // Gauss-Seidel sweeps after each correction

int longestSpan(const PixelLevel& level) {
  int longest = 0;
  for (const PixelSpan& span : level.spans) longest = std::max(longest, span.end - span.begin);
  return longest;
}

Vec2 weightedNeighbours(const GraphLevel& level, const Field& field, std::size_t i) {
  Vec2 sum;
  for (int link = level.firstLink[i]; link < level.firstLink[i + 1]; ++link) {
    sum += level.linkWeight[at(link)] * field[at(level.linkTo[at(link)])];
  }
  return sum;
}

}  // namespace

Multigrid::Multigrid(PixelLevel finest, Size size, Pixel origin) : finest_(std::move(finest)) {
  int side = 2;
  if (finest_.hasLinks()) levels_.push_back(coarserLevel(finest_, size, origin));
  while (!levels_.empty() && !levels_.back().linkTo.empty()) {
    side *= 2;
    GraphLevel coarser = coarserLevel(levels_.back(), side);
    levels_.push_back(std::move(coarser));
  }
  for (const GraphLevel& level : levels_) {
    right_.emplace_back(at(level.count()));
    value_.emplace_back(at(level.count()));
    shares_.emplace_back();
    for (const float diagonal : level.diagonal) shares_.back().push_back(1.0F / diagonal);
  }
  finestRight_ = Field(at(finest_.count));
  finestValue_ = Field(at(finest_.count));
  plain_ = Field(at(finest_.count));
  zeros_ = Field(at(longestSpan(finest_)));
}

void Multigrid::setResidual(int piece, const PreciseField& residual) {
  forEachSpan(piece, [&](const PixelSpan& span) {
    const float share = 1.0F / span.diagonal;
    for (int i = span.begin; i < span.end; ++i) {
      finestRight_[at(i)] = toFloat(residual[at(i)]);
      plain_[at(i)] = share * finestRight_[at(i)];
    }
  });
}

const Field& Multigrid::cycle() {
  // Without links one division per unknown is the solution
  if (levels_.empty()) return plain_;
  restrictFinest();
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) restrict(l);

  const GraphLevel& coarsest = levels_.back();
  forEachUnknown(0, coarsest.count(),
                 [&](std::size_t i) { value_.back()[i] = shares_.back()[i] * right_.back()[i]; });
  for (std::size_t l = levels_.size() - 1; l-- > 0;) {
    prolongate(l);
    for (int sweep = 0; sweep < kSmoothings; ++sweep) smooth(l);
  }
  prolongateFinest();
  for (int sweep = 0; sweep < kSmoothings; ++sweep) smoothFinest();
  return finestValue_;
}

void Multigrid::restrict(std::size_t l) {
  const GraphLevel& fine = levels_[l];
  const GraphLevel& coarse = levels_[l + 1];
  forEachUnknown(0, fine.count(), [&](std::size_t i) { plain_[i] = shares_[l][i] * right_[l][i]; });
  forEachUnknown(0, coarse.count(), [&](std::size_t i) {
    Vec2 sum;
    for (int c = coarse.firstChild[i]; c < coarse.firstChild[i + 1]; ++c) {
      sum += weightedNeighbours(fine, plain_, at(coarse.child[at(c)]));
    }
    right_[l + 1][i] = sum;
  });
}

void Multigrid::restrictFinest() {
  forEachPiece(0, pieceCount(finest_.count), [&](int piece) {
    forEachSpan(piece, [&](const PixelSpan& span) {
      const Beside<Vec2> beside(span, plain_, zeros_);
      Vec2* sums = finestValue_.data() + span.begin;
#pragma omp simd
      for (int k = 0; k < span.end - span.begin; ++k) sums[k] = beside.sum(k);
    });
  });
  const GraphLevel& coarse = levels_.front();
  forEachUnknown(0, coarse.count(), [&](std::size_t i) {
    Vec2 sum;
    for (int c = coarse.firstChild[i]; c < coarse.firstChild[i + 1]; ++c) {
      sum += finestValue_[at(coarse.child[at(c)])];
    }
    right_.front()[i] = sum;
  });
}

void Multigrid::prolongate(std::size_t l) {
  const GraphLevel& level = levels_[l];
  forEachUnknown(0, level.redCount,
                 [&](std::size_t i) { plain_[i] = value_[l + 1][at(level.parent[i])]; });
  forEachUnknown(level.redCount, level.count(), [&](std::size_t i) {
    value_[l][i] = shares_[l][i] * weightedNeighbours(level, plain_, i);
  });
}

void Multigrid::prolongateFinest() {
  forEachUnknown(0, finest_.redCount,
                 [&](std::size_t i) { plain_[i] = value_.front()[at(finest_.parent[i])]; });
  forEachColorSpan(finest_.redSpans, static_cast<int>(finest_.spans.size()),
                   [&](const PixelSpan& span) {
                     const float share = 1.0F / span.diagonal;
                     const Beside<Vec2> beside(span, plain_, zeros_);
                     Vec2* out = finestValue_.data() + span.begin;
#pragma omp simd
                     for (int k = 0; k < span.end - span.begin; ++k) out[k] = share * beside.sum(k);
                   });
}

void Multigrid::smooth(std::size_t l) {
  const GraphLevel& level = levels_[l];
  const auto relax = [&](std::size_t i) {
    value_[l][i] = shares_[l][i] * (right_[l][i] + weightedNeighbours(level, value_[l], i));
  };
  forEachUnknown(0, level.redCount, relax);
  forEachUnknown(level.redCount, level.count(), relax);
}

void Multigrid::smoothFinest() {
  const auto relax = [&](const PixelSpan& span) {
    const float share = 1.0F / span.diagonal;
    const Beside<Vec2> beside(span, finestValue_, zeros_);
    const Vec2* right = finestRight_.data() + span.begin;
    Vec2* out = finestValue_.data() + span.begin;
#pragma omp simd
    for (int k = 0; k < span.end - span.begin; ++k) {
      out[k] = share * (right[k] + beside.sum(k));
    }
  };
  forEachColorSpan(0, finest_.redSpans, relax);
  forEachColorSpan(finest_.redSpans, static_cast<int>(finest_.spans.size()), relax);
}

}  // namespace fluidymation

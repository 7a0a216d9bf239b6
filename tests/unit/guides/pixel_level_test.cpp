#include "guides/pixel_level.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "fluidymation/core/index.h"
#include "fluidymation/guides/motion.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

/// A region with its border, or with a border of some of its pixels.
struct Problem {
  Mask region;
  Mask border;
};

std::vector<Problem> problems() {
  std::vector<Problem> all;
  for (const Size size : {Size{40, 34}, Size{150, 140}, Size{17, 3}, Size{1, 1}}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      Mask blobs = test::randomBlobs(size, seed);
      Mask border = borderPixels(blobs);
      all.push_back({std::move(blobs), std::move(border)});
      Mask noise = test::randomMask(size, seed, 70);
      Mask some = test::randomMask(size, seed + 50, 3);
      for (std::size_t i = 0; i < some.pixelCount(); ++i) {
        if (noise.data()[i] == 0) some.data()[i] = 0;
      }
      all.push_back({std::move(noise), std::move(some)});
    }
    Mask corner(size);
    corner(0, 0) = 1;
    all.push_back({Mask(size, 1), std::move(corner)});
    all.push_back({Mask(size, 1), Mask(size)});
  }
  return all;
}

/// The unknown at each pixel, -1 where there is none: red before black, each in row order.
Image<int> unknownsOf(const Problem& problem, int& count) {
  Image<int> reached(problem.region.size(), 0);
  for (bool grew = true; grew;) {
    grew = false;
    for (int y = 0; y < reached.height(); ++y) {
      for (int x = 0; x < reached.width(); ++x) {
        if (reached(x, y) != 0 || problem.region(x, y) == 0 || problem.border(x, y) != 0) continue;
        for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
          if (!reached.contains(x + dx, y + dy)) continue;
          if (reached(x + dx, y + dy) != 0 || problem.border(x + dx, y + dy) != 0) {
            reached(x, y) = 1;
            grew = true;
          }
        }
      }
    }
  }
  Image<int> unknowns(reached.size(), -1);
  count = 0;
  for (const int color : {0, 1}) {
    for (int y = 0; y < reached.height(); ++y) {
      for (int x = 0; x < reached.width(); ++x) {
        if (reached(x, y) != 0 && (x + y) % 2 == color) unknowns(x, y) = count++;
      }
    }
  }
  return unknowns;
}

TEST(PixelLevel, SpansTellTheNeighboursOfEachPixel) {
  for (const Problem& problem : problems()) {
    int count = 0;
    const Image<int> unknowns = unknownsOf(problem, count);
    const PixelLevel level = pixelLevel(problem.region, problem.border);
    ASSERT_EQ(level.count, count);
    int next = 0;
    for (std::size_t s = 0; s < level.spans.size(); ++s) {
      const PixelSpan& span = level.spans[s];
      EXPECT_EQ(static_cast<int>(s) < level.redSpans, span.begin < level.redCount);
      EXPECT_EQ(span.begin / kUnknownsAtATime, (span.end - 1) / kUnknownsAtATime);
      for (int i = span.begin; i < span.end; ++i) {
        const int k = i - span.begin;
        const int x = span.x + 2 * k;
        ASSERT_EQ(i, next++);
        ASSERT_EQ(unknowns(x, span.y), i);
        int given = 0;
        int linked = 0;
        const auto expectLink = [&](int link, int nx, int ny) {
          const bool within = unknowns.contains(nx, ny);
          const int expected = within ? unknowns(nx, ny) : -1;
          EXPECT_EQ(link == kNoUnknown ? -1 : link + k, expected);
          if (within && problem.border(nx, ny) != 0) ++given;
          if (expected >= 0) ++linked;
        };
        expectLink(span.left, x - 1, span.y);
        expectLink(span.right, x + 1, span.y);
        expectLink(span.up, x, span.y - 1);
        expectLink(span.down, x, span.y + 1);
        EXPECT_EQ(span.given, given);
        EXPECT_EQ(span.diagonal, static_cast<float>(given + linked));
      }
    }
    EXPECT_EQ(next, count);
    for (std::size_t piece = 0; piece + 1 < level.firstSpan.size(); ++piece) {
      EXPECT_EQ(level.spans[at(level.firstSpan[piece])].begin,
                static_cast<int>(piece) * kUnknownsAtATime);
    }
  }
}

/// The pixels as a level of blocks of side 1, link by link.
GraphLevel linkedPixels(const Problem& problem, Pixel origin) {
  int count = 0;
  const Image<int> unknowns = unknownsOf(problem, count);
  GraphLevel level;
  level.firstLink.push_back(0);
  level.blockX.resize(at(count));
  level.blockY.resize(at(count));
  for (int y = 0; y < unknowns.height(); ++y) {
    for (int x = 0; x < unknowns.width(); ++x) {
      if (unknowns(x, y) < 0) continue;
      level.blockX[at(unknowns(x, y))] = x;
      level.blockY[at(unknowns(x, y))] = y;
    }
  }
  for (std::size_t i = 0; i < at(count); ++i) {
    float given = 0.0F;
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const int x = level.blockX[i] + dx;
      const int y = level.blockY[i] + dy;
      if (!unknowns.contains(x, y)) continue;
      if (problem.border(x, y) != 0) given += 1.0F;
      if (unknowns(x, y) >= 0) level.linkTo.push_back(unknowns(x, y));
    }
    level.givenPairs.push_back(given);
    level.firstLink.push_back(static_cast<int>(level.linkTo.size()));
  }
  level.diagonal.resize(at(count));
  level.pixelCount.assign(at(count), 1.0F);
  level.linkPairs.assign(level.linkTo.size(), 1.0F);
  for (int& x : level.blockX) x += origin.x;
  for (int& y : level.blockY) y += origin.y;
  return level;
}

TEST(PixelLevel, HasTheCoarserLevelOfItsLinks) {
  for (const Problem& problem : problems()) {
    for (const Pixel origin : {Pixel{0, 0}, Pixel{6, 0}, Pixel{2, 4}}) {
      PixelLevel pixels = pixelLevel(problem.region, problem.border);
      GraphLevel links = linkedPixels(problem, origin);
      const GraphLevel coarse = coarserLevel(pixels, problem.region.size(), origin);
      const GraphLevel expected = coarserLevel(links, 2);
      EXPECT_EQ(pixels.parent, links.parent);
      EXPECT_EQ(coarse.redCount, expected.redCount);
      EXPECT_EQ(coarse.blockX, expected.blockX);
      EXPECT_EQ(coarse.blockY, expected.blockY);
      EXPECT_EQ(coarse.firstLink, expected.firstLink);
      EXPECT_EQ(coarse.linkTo, expected.linkTo);
      EXPECT_EQ(coarse.linkPairs, expected.linkPairs);
      EXPECT_EQ(coarse.linkWeight, expected.linkWeight);
      EXPECT_EQ(coarse.diagonal, expected.diagonal);
      EXPECT_EQ(coarse.givenPairs, expected.givenPairs);
      EXPECT_EQ(coarse.pixelCount, expected.pixelCount);
      EXPECT_EQ(coarse.firstChild, expected.firstChild);
      EXPECT_EQ(coarse.child, expected.child);
    }
  }
}

}  // namespace
}  // namespace fluidymation

#include "cli/nearest.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace fluidymation::cli {
namespace {

constexpr std::size_t kLongestWord = 40;  // bytes; no option has more
constexpr std::size_t kMostSlips = 3;     // beyond, it is another word

/// Letters to insert, delete or replace to turn `a` into `b` (Levenshtein).
[[nodiscard]] std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

/// Letters with which both words begin.
[[nodiscard]] std::size_t commonBeginning(const std::string& a, const std::string& b) {
  const auto differ = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(differ.first - a.begin());
}

/// The candidate that begins most like `word`, which ends otherwise.
[[nodiscard]] std::string nearestBeginning(const std::string& word,
                                           const std::vector<std::string>& candidates) {
  std::string found;
  std::size_t longest = 0;
  for (const std::string& candidate : candidates) {
    const std::size_t common = commonBeginning(word, candidate);
    const std::size_t longer = std::max(word.size(), candidate.size());
    const bool isAlike = 4 * common >= 3 * longer;  // three quarters: --src-x is no --src-path
    if (common <= longest || !isAlike) continue;
    longest = common;
    found = candidate;
  }
  return found;
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  std::string found;
  std::size_t smallest = kMostSlips + 1;
  if (word.size() > kLongestWord) return found;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(word, candidate);
    // Half a word of slips is another word
    if (distance >= smallest || 2 * distance >= candidate.size()) continue;
    smallest = distance;
    found = candidate;
  }
  return found.empty() ? nearestBeginning(word, candidates) : found;
}

std::string choiceText(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

std::string wantedWord(const std::string& word, const std::vector<std::string>& words) {
  const std::string likely = nearest(word, words);
  return "wanted " + choiceText(words) + (likely.empty() ? "" : "; did you mean " + likely + "?");
}

}  // namespace fluidymation::cli

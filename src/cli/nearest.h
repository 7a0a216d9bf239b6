#pragma once

#include <string>
#include <vector>

namespace fluidymation::cli {

/// The candidate that a slip of the fingers turns into `word`: the one with the fewest letters to
/// insert, delete or replace (Levenshtein). Where none is near, the one that begins most like it,
/// if the common beginning is at least three quarters of the longer word. Of several the first;
/// empty where there is none.
[[nodiscard]] std::string nearest(const std::string& word,
                                  const std::vector<std::string>& candidates);

/// "a", "a or b", "a, b or c".
[[nodiscard]] std::string choiceText(const std::vector<std::string>& words);

/// "wanted a, b or c", and where one of them is near to `word`, which one may have been meant.
[[nodiscard]] std::string wantedWord(const std::string& word,
                                     const std::vector<std::string>& words);

}  // namespace fluidymation::cli

#!/usr/bin/env bash
# Paints the golden pictures of tests/golden anew.
#
# Right only when a change of the painting is meant: the commit that makes it has been looked at on
# real samples, and the pictures differ because of it. The update is a commit of its own, with the
# pictures before and after in its message or beside it: output/golden/{before,after}/<name>.
# Never update to make a failing test pass whose cause is not known.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
show=output/golden
rm -rf "$show"
mkdir -p "$show/before" "$show/after"
cmake --preset dev
cmake --build --preset dev --parallel "$(nproc)" --target test_end_to_end
if [ -d tests/golden ]; then cp -r tests/golden/. "$show/before/"; fi
FLUIDYMATION_UPDATE_GOLDEN=1 build/dev/tests/cli/test_end_to_end --gtest_filter='EndToEndGolden.*'
cp -r tests/golden/. "$show/after/"
build/dev/tests/cli/test_end_to_end --gtest_filter='EndToEndGolden.*'
if git diff --quiet -- tests/golden && [ -z "$(git status --porcelain -- tests/golden)" ]; then
  echo "No picture has changed."
else
  git status --short -- tests/golden
  echo "Look at $show/before and $show/after, then commit tests/golden on its own."
fi

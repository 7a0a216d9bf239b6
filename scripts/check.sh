#!/usr/bin/env bash
# Everything beyond the tests that has to hold: sanitizer builds, format, static checks.
# Usage: scripts/check.sh [asan] [tsan] [format] [tidy]     (default: all)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install_packages.sh build samples test check
jobs=$(nproc)
checks=("$@")
[ ${#checks[@]} -gt 0 ] || checks=(format asan tsan tidy)

check_asan() {
  cmake --preset asan
  cmake --build --preset asan --parallel "$jobs"
  ctest --preset asan --parallel "$jobs"
}

# The rooms that have threads. OpenMP's own runtime is not instrumented: races inside it are not ours.
check_tsan() {
  local rooms=(core guides synthesis pipeline)
  cmake --preset tsan
  cmake --build --preset tsan --parallel "$jobs" --target "${rooms[@]/#/test_}"
  TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1" OMP_NUM_THREADS=4 \
    ctest --preset tsan --parallel "$jobs" --label-regex "^($(IFS='|'; echo "${rooms[*]}"))\$"
}

check_format() {
  git ls-files '*.cpp' '*.h' | xargs clang-format --dry-run --Werror
}

# Against the asan configuration: there asserts hold, and the analyzer learns from them.
check_tidy() {
  cmake --preset asan
  git ls-files 'src/*.cpp' | xargs -P "$jobs" -n 1 clang-tidy -p build/asan --quiet \
    --warnings-as-errors='*'
}

for check in "${checks[@]}"; do
  echo "== $check"
  "check_$check"
done

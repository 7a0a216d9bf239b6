#!/usr/bin/env bash
# Measures the stages of a frame, or compares the whole tool with another build of it.
# Usage: scripts/benchmark.sh [OPTION...]
#          builds and runs fluidymation_bench; --bench-help shows its options
#        scripts/benchmark.sh --against GITREF|PROGRAM [OPTION...]
#          builds the tool as it stands (A) and at GITREF (B), and times runs of both in turn;
#          options: --case NAME --frames MANY --few FEW --pairs N --threads N
#          B is kept in build/against/COMMIT for the next time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh

against=
rest=()
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help)
      usage
      exit 0
      ;;
    --bench-help) rest+=(--help) ;;
    --against)
      [ $# -ge 2 ] || refuse "--against: wanted a commit or a program"
      against=$2
      shift
      ;;
    *) rest+=("$1") ;;
  esac
  shift
done
require_own_folders

build() { # TARGET, of the release preset in the current folder
  cmake --preset release
  cmake --build --preset release --parallel "$(nproc)" --target "$1"
}

if [ -z "$against" ]; then
  scripts/install_packages.sh build
  build fluidymation_bench >&2
  exec build/release/fluidymation_bench "${rest[@]}"
fi

commit=
if [ -x "$against" ] && [ -f "$against" ]; then
  program=$against
else
  commit=$(git rev-parse --quiet --verify "$against^{commit}") ||
    refuse "--against $against: neither a commit nor a program"
  program=build/against/$commit/fluidymation
fi
scripts/install_packages.sh build samples
build fluidymation >&2

if [ -n "$commit" ] && [ ! -x "$program" ]; then
  tree=$(mktemp -d)
  trap 'rm -rf "$tree"' EXIT
  trap 'exit 130' INT TERM
  git archive "$commit" | tar -x -C "$tree"
  (cd "$tree" && build fluidymation) >&2
  mkdir -p "$(dirname "$program")"
  mv "$tree/build/release/fluidymation" "$program"
fi
echo "A is $(git describe --always --dirty --exclude='*' --abbrev=12), B is $against"
scripts/benchmark_compare.py --program build/release/fluidymation --against "$program" "${rest[@]}"

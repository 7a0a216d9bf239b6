#!/usr/bin/env bash
# Measures the stages of a frame, or compares the whole tool with another build of it.
# Usage: scripts/benchmark.sh [OPTION...]
#          builds and runs build/bench/fluidymation_bench; --bench-help shows its options
#        scripts/benchmark.sh --against GITREF|PROGRAM [OPTION...]
#          builds the tool as it stands (A) and at GITREF (B), and times runs of both in turn;
#          options: --case NAME --frames MANY --few FEW --pairs N --threads N
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
jobs=$(nproc)

if [ -z "$against" ]; then
  scripts/install_packages.sh build
  { cmake -S tests/bench -B build/bench &&
    cmake --build build/bench --parallel "$jobs" --target fluidymation_bench; } >&2
  exec build/bench/fluidymation_bench "${rest[@]}"
fi

if [ -x "$against" ] && [ -f "$against" ]; then
  program=$against
else
  git rev-parse --quiet --verify "$against^{commit}" >/dev/null ||
    refuse "--against $against: neither a commit nor a program"
  program=
fi
scripts/install_packages.sh build samples
cmake --preset release >&2
cmake --build --preset release --parallel "$jobs" >&2

if [ -z "$program" ]; then
  folder=$(mktemp -d)
  remove_worktree() {
    git worktree remove --force "$folder/tree" 2>/dev/null || true
    rm -rf "$folder"
  }
  trap remove_worktree EXIT
  trap 'exit 130' INT TERM
  git worktree add --quiet --detach "$folder/tree" "$against"
  (cd "$folder/tree" && cmake --preset release &&
    cmake --build --preset release --parallel "$jobs") >&2
  program=$folder/tree/build/release/fluidymation
fi
echo "A is $(git describe --always --dirty --abbrev=12), B is $against"
scripts/benchmark_compare.py --program build/release/fluidymation --against "$program" "${rest[@]}"

#!/usr/bin/env bash
# Looks for input that breaks a promise: builds the fuzzers of tests/fuzz with address and undefined
# behaviour sanitizers and runs them one after the other, from the committed corpora on.
# Usage: scripts/fuzz.sh [TARGET...] [--minutes N]
#   TARGET     png, flow, pattern, options, state, manifest or config (default: all)
#   --minutes  for each target, of processor time (default 5)
# What is found lies in output/fuzz/TARGET/finds; copied to tests/fuzz/finds/TARGET, every test run tries
# it again. What the runs have learned stays in output/fuzz/TARGET/corpus for the next ones. Prints one
# line a target: executions, edges covered, processor time up to its last second. Exit code 1 where anything was found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
minutes=5
targets=()
while [ $# -gt 0 ]; do
  case $1 in
    --minutes) minutes=${2:?--minutes: the number is missing}; shift ;;
    png | flow | pattern | options | state | manifest | config) targets+=("$1") ;;
    *) echo "scripts/fuzz.sh: $1: wanted png, flow, pattern, options, state, manifest, config or --minutes N" >&2; exit 2 ;;
  esac
  shift
done
[[ $minutes =~ ^[1-9][0-9]*$ ]] || { echo "scripts/fuzz.sh: --minutes $minutes: wanted a whole number" >&2; exit 2; }
[ ${#targets[@]} -gt 0 ] || targets=(png flow pattern options state manifest config)

scripts/install_packages.sh build test check
cmake --preset fuzz
cmake --build --preset fuzz --parallel "$(nproc)" --target "${targets[@]/#/fuzz_}"

# Asks process $1 to end once it has used $2 seconds of processor time; sets used_s.
stop_after() {
  local ticks now_s
  ticks=$(getconf CLK_TCK)
  used_s=0
  while kill -0 "$1" 2> /dev/null; do
    # Behind the name in brackets, fields 12 and 13 are the user's and the system's share, in ticks.
    now_s=$(awk -v ticks="$ticks" '{ sub(/.*\) /, ""); print int(($12 + $13) / ticks) }' "/proc/$1/stat" 2> /dev/null) \
      || break
    used_s=$now_s
    [ "$used_s" -lt "$2" ] || kill -USR1 "$1" 2> /dev/null || break
    sleep 1
  done
}

longest_input=4096  # bytes; seeds are smaller
slowest_s=60        # an input that takes longer is a find
found=0
export OMP_NUM_THREADS=1
trap 'kill $(jobs -p) 2> /dev/null || true' EXIT  # no fuzzer outlives this script
for target in "${targets[@]}"; do
  place=output/fuzz/$target
  mkdir -p "$place/corpus" "$place/finds"
  seeds=("tests/fuzz/corpus/$target")
  [ ! -d "tests/fuzz/finds/$target" ] || seeds+=("tests/fuzz/finds/$target")
  "build/fuzz/tests/fuzz/fuzz_$target" -max_len=$longest_input -timeout=$slowest_s -report_slow_units=$slowest_s \
    -print_final_stats=1 -artifact_prefix="$place/finds/" "$place/corpus" "${seeds[@]}" > "$place/log" 2>&1 &
  stop_after "$!" $((60 * minutes))
  wait "$!" || found=1
  executions=$(sed -n 's/^stat::number_of_executed_units: //p' "$place/log")
  edges=$(grep -o 'cov: [0-9]*' "$place/log" | tail -n 1 | cut -d ' ' -f 2)
  all=$(sed -n 's/^INFO: Loaded 1 modules *(\([0-9]*\) .*/\1/p' "$place/log")
  echo "$target: ${executions:-?} executions, ${edges:-?} of ${all:-?} edges," \
    "$used_s s of processor time," \
    "$(find "$place/finds" -type f | wc -l) finds (log: $place/log)"
done
exit $found

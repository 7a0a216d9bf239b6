#!/usr/bin/env bash
# Paints every sample exemplar x target combination. Resumable: a combination that is complete and was
# painted by the same command is left alone, any other starts again. The command is kept beside the
# frames, in OUT_DIR/<name>.command. Ends with a list of what failed.
# Usage: scripts/generate_all.sh [OUT_DIR] [EXEMPLAR...]     (default: output/all, every exemplar)
# Environment: FLUIDYMATION  the tool (default: build/release/fluidymation)
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out=${1:-output/all}
[ $# -gt 0 ] && shift
tool=${FLUIDYMATION:-build/release/fluidymation}
[ -x "$tool" ] || { echo "$tool is missing: build it with scripts/demo.sh" >&2; exit 1; }

targets=(genie horse jump squiggle sunflower waving)
if [ $# -gt 0 ]; then
  exemplars=("$@")
else
  exemplars=()
  for folder in samples/source/*/; do exemplars+=("$(basename "$folder")"); done
fi

failed=()
for exemplar in "${exemplars[@]}"; do
  # One option and its value a line; empty lines and lines that begin with # do not count.
  mapfile -t parameters < <(grep -vE '^\s*(#|$)' "samples/source/$exemplar/parameters.txt" |
    tr -s ' ' '\n')
  for target in "${targets[@]}"; do
    name=$exemplar-$target
    folder=$out/$name
    command=("$tool" --src-path "samples/source/$exemplar/rgb/%05d.png"
      --src-mask-path "samples/source/$exemplar/mask/%05d.png"
      --target-path "samples/target-mask/$target/%05d.png" --target-frames 1000
      --out-path "$folder.partial/%05d.png" --quiet "${parameters[@]}")
    stamp=$folder.command
    if [ -d "$folder" ] && [ "$(cat "$stamp" 2>/dev/null)" = "${command[*]@Q}" ]; then
      echo "$name: complete, left alone"
    else
      echo "$name: painting"
      # The old stamp first: whatever happens now, it must not vouch for other frames.
      rm -rf "$stamp" "$folder.partial"; rm -f "$out/$name.png"
      started=$SECONDS
      "${command[@]}"
      status=$?
      # Stopped by Ctrl-C or SIGTERM, as the tool says it: the next one is not wanted either.
      case $status in 130 | 143) exit $status ;; esac
      if [ $status -ne 0 ] || ! rm -rf "$folder" || ! mv "$folder.partial" "$folder" ||
        ! printf '%s\n' "${command[*]@Q}" >"$stamp"; then
        failed+=("$name")
        continue
      fi
      echo "$name: done in $((SECONDS - started)) s, $folder"
    fi
    if [ ! -f "$out/$name.png" ] &&
      ! scripts/contact_sheet.py --exemplar "samples/source/$exemplar" \
        --target "samples/target-mask/$target" --painted "$folder" --out "$out/$name.png"; then
      failed+=("$name (contact sheet)")
    fi
  done
done

if [ ${#failed[@]} -gt 0 ]; then
  printf 'failed: %s\n' "${failed[@]}" >&2
  exit 1
fi
echo "all combinations are in $out"

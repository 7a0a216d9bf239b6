#!/usr/bin/env bash
# Paints every sample exemplar x target combination. Resumable: a combination that is complete is
# left alone, one that was interrupted starts again. Ends with a list of what failed.
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
    if [ -d "$folder" ]; then
      echo "$name: complete, left alone"
      continue
    fi
    echo "$name: painting"
    rm -rf "$folder.partial"
    started=$SECONDS
    if "$tool" --src-path "samples/source/$exemplar/rgb/%05d.png" \
      --src-mask-path "samples/source/$exemplar/mask/%05d.png" \
      --target-path "samples/target-mask/$target/%05d.png" --target-frames 1000 \
      --out-path "$folder.partial/%05d.png" --quiet "${parameters[@]}" &&
      mv "$folder.partial" "$folder"; then
      echo "$name: done in $((SECONDS - started)) s, $folder"
      scripts/contact_sheet.py --exemplar "samples/source/$exemplar" \
        --target "samples/target-mask/$target" --painted "$folder" --out "$out/$name.png"
    else
      failed+=("$name")
    fi
  done
done

if [ ${#failed[@]} -gt 0 ]; then
  printf 'failed: %s\n' "${failed[@]}" >&2
  exit 1
fi
echo "all combinations are in $out"

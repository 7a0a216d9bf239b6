#!/usr/bin/env bash
# Makes the pictures of docs/gallery.md from what scripts/generate_all.sh painted.
# Usage: scripts/render_gallery.sh [PAINTED_DIR]     (default: output/all)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
take_no_options "$@"
[ $# -le 1 ] || refuse "$# arguments; wanted at most PAINTED_DIR"
painted=${1:-output/all}
gallery=("watercolour horse" "watercolour sunflower" "ink horse" "ink squiggle" "rust waving"
  "rust jump")
for pair in "${gallery[@]}"; do
  folder=$painted/${pair/ /-}
  [ -d "$folder" ] || {
    echo "render_gallery.sh: $folder is missing; run scripts/generate_all.sh $painted first" >&2
    exit 1
  }
done
mkdir -p docs/images

sheet() { # EXEMPLAR TARGET OUT COLUMNS WIDTH
  scripts/contact_sheet.py --exemplar "samples/source/$1" --target "samples/target-mask/$2" \
    --painted "$painted/$1-$2" --out "docs/images/$3.png" --columns "$4" --width "$5"
}

sheet watercolour horse teaser 4 320
for pair in "${gallery[@]}"; do
  read -r exemplar target <<<"$pair"
  sheet "$exemplar" "$target" "$exemplar-$target" 5 176
done

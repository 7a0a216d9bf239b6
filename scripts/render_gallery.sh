#!/usr/bin/env bash
# Makes the pictures of docs/gallery.md from what scripts/generate_all.sh painted.
# Usage: scripts/render_gallery.sh [PAINTED_DIR]     (default: output/all)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
painted=${1:-output/all}
mkdir -p docs/images

sheet() { # EXEMPLAR TARGET
  scripts/contact_sheet.py --exemplar "samples/source/$1" --target "samples/target-mask/$2" \
    --painted "$painted/$1-$2" --out "docs/images/$1-$2.png" --columns 5 --width 176
}

scripts/contact_sheet.py --exemplar samples/source/watercolour --target samples/target-mask/horse \
  --painted "$painted/watercolour-horse" --out docs/images/teaser.png --columns 4 --width 320
sheet watercolour horse
sheet watercolour sunflower
sheet ink horse
sheet ink squiggle
sheet rust waving
sheet rust jump

#!/usr/bin/env bash
# Installs what is needed, builds, paints a bundled sample and says where to look.
# Usage: scripts/demo.sh [EXEMPLAR [TARGET [FRAMES]]]    (default: watercolour horse 30)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exemplar=${1:-watercolour}
target=${2:-horse}
frames=${3:-30}
for folder in "samples/source/$exemplar" "samples/target-mask/$target"; do
  [ -d "$folder" ] || { echo "$folder: no such sample; there are:" samples/source/*/ \
    samples/target-mask/*/ >&2; exit 2; }
done

scripts/install_packages.sh build samples
cmake --preset release
cmake --build --preset release --parallel "$(nproc)"

out=output/demo/$exemplar-$target
rm -rf "$out"
mapfile -t parameters < <(grep -vE '^\s*(#|$)' "samples/source/$exemplar/parameters.txt" |
  tr -s ' ' '\n')
command=(build/release/fluidymation
  --src-path "samples/source/$exemplar/rgb/%05d.png"
  --src-mask-path "samples/source/$exemplar/mask/%05d.png"
  --target-path "samples/target-mask/$target/%05d.png" --target-frames "$frames"
  --out-path "$out/frames/%05d.png" "${parameters[@]}")
echo "${command[*]}"
"${command[@]}"

scripts/contact_sheet.py --exemplar "samples/source/$exemplar" \
  --target "samples/target-mask/$target" --painted "$out/frames" --out "$out/contact-sheet.png"
echo
echo "Look at:"
echo "  $out/contact-sheet.png   exemplar, masks and result side by side"
echo "  $out/frames/             the painted frames: RGBA, transparent outside the shape"
scripts/preview.sh "$out/frames" "$out/preview" | sed 's/^/  /'

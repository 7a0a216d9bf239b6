#!/usr/bin/env bash
# Installs what is needed, builds, paints a bundled sample and says where to look.
# Usage: scripts/demo.sh [EXEMPLAR [TARGET [FRAMES]]]    (default: watercolour horse 30)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
case ${1:-} in
  -h | --help)
    usage
    echo "Exemplars: $(exemplar_names | paste -sd ' ')"
    echo "Targets:   $(target_names | paste -sd ' ')"
    exit 0
    ;;
esac
[ $# -le 3 ] || refuse "$# arguments; wanted at most EXEMPLAR TARGET FRAMES"
exemplar=${1:-watercolour}
target=${2:-horse}
frames=${3:-30}
require_exemplar "$exemplar"
require_target "$target"
require_frames "$frames"
require_own_folders

scripts/install_packages.sh build samples
cmake --preset release
cmake --build --preset release --parallel "$(nproc)"

out=output/demo/$exemplar-${target//\//-}
rm -rf "$out"
mapfile -t parameters < <(parameters_of "$exemplar")
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

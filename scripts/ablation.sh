#!/usr/bin/env bash
# Repeats the paper's ablation study (P§4) on two samples: each term of the energy switched off.
# Writes OUT_DIR/table.md, figures by the program JUDGE (see scripts/quality/measure.py), and
# OUT_DIR/<pair>.png, one row of frames a variant.
# Usage: scripts/ablation.sh JUDGE [OUT_DIR] [FRAMES]     (default: output/ablation, 12)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
take_no_options "$@"
[ $# -ge 1 ] && [ $# -le 3 ] || refuse "$# arguments; wanted JUDGE [OUT_DIR] [FRAMES]"
judge=$1
out=${2:-output/ablation}
frames=${3:-12}
[ -f "$judge" ] || refuse "$judge: no such file; wanted a program that judges, such as quality.py"
[ -x build/release/fluidymation ] || refuse "build/release/fluidymation is missing; build it first"
scripts/quality/measure.py --judge "$judge" --pairs scripts/quality/ablation_pairs.tsv \
  --variants scripts/quality/ablation.tsv --out "$out" --frames "$frames"
while IFS=$'\t' read -r pair exemplar _; do
  [[ $pair == \#* ]] || scripts/quality/variants_sheet.py --painted "$out" --pair "$pair" \
    --variants scripts/quality/ablation.tsv --exemplar "$exemplar" --out "$out/$pair.png"
done <scripts/quality/ablation_pairs.tsv
echo "Look at $out/table.md and the pictures beside it."

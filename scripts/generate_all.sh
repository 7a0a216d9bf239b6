#!/usr/bin/env bash
# Paints every sample exemplar x target combination. Resumable: a combination that is complete and was
# painted by the same command is left alone, any other starts again. The command is kept beside the
# frames, in OUT_DIR/<name>.command. Ends with a list of what failed.
# Usage: scripts/generate_all.sh [--targets NAME,...] [--frames N] [OUT_DIR [EXEMPLAR...]]
#   OUT_DIR        folder for the painted frames (default: output/all)
#   EXEMPLAR...    only these (default: all)
#   --targets      only these (default: all but the layers of waving)
#   --frames       of each target, at most (default: all)
# Environment: FLUIDYMATION  the tool (default: build/release/fluidymation)
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
source scripts/common.sh

mapfile -t targets < <(target_names | grep -v /)
mapfile -t exemplars < <(exemplar_names)
frames=1000
positional=()
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help)
      usage
      echo "Exemplars: ${exemplars[*]}"
      echo "Targets:   $(target_names | paste -sd ' ')"
      exit 0
      ;;
    --targets | --frames)
      [ -n "${2:-}" ] || refuse "$1: the value is missing"
      if [ "$1" = --targets ]; then IFS=, read -ra targets <<<"$2"; else frames=$2; fi
      shift 2
      ;;
    -*) refuse "$1: no such option; see --help" ;;
    *)
      positional+=("$1")
      shift
      ;;
  esac
done
out=${positional[0]:-output/all}
[ ${#positional[@]} -le 1 ] || exemplars=("${positional[@]:1}")
if grep -qxF -- "$out" <<<"$(exemplar_names)"; then
  refuse "$out is an exemplar; the folder comes first: scripts/generate_all.sh output/all $out"
fi
for exemplar in "${exemplars[@]}"; do require_exemplar "$exemplar"; done
for target in "${targets[@]}"; do require_target "$target"; done
require_frames "$frames"
tool=${FLUIDYMATION:-build/release/fluidymation}
[ -x "$tool" ] || {
  echo "generate_all.sh: $tool is missing; scripts/demo.sh builds it, or: cmake --preset release &&" \
    "cmake --build --preset release" >&2
  exit 1
}

failed=()
for exemplar in "${exemplars[@]}"; do
  mapfile -t parameters < <(parameters_of "$exemplar")
  for target in "${targets[@]}"; do
    name=$exemplar-${target//\//-}
    folder=$out/$name
    command=("$tool" --src-path "samples/source/$exemplar/rgb/%05d.png"
      --src-mask-path "samples/source/$exemplar/mask/%05d.png"
      --target-path "samples/target-mask/$target/%05d.png" --target-frames "$frames"
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

#!/usr/bin/env bash
# Builds the tool for 64-bit ARM with a cross compiler, paints with it in an emulator, and compares all bytes with
# those of a build for this machine.
# Usage: scripts/test_aarch64.sh [TOOL]    TOOL: this machine's (default: build/release/fluidymation)
# For Debian on another processor; libraries for ARM (about 60 MB) are downloaded to build/aarch64-sysroot.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
take_no_options "$@"
[ $# -le 1 ] || refuse "$# arguments; wanted at most TOOL"
tool=${1:-build/release/fluidymation}
[ -x "$tool" ] || refuse "$tool: no program; build it first, or name it"
scripts/install_packages.sh build aarch64

export AARCH64_SYSROOT=$PWD/build/aarch64-sysroot
if [ ! -e "$AARCH64_SYSROOT/usr/include/png.h" ]; then
  rm -rf "$AARCH64_SYSROOT"
  mmdebstrap --architectures=arm64 --variant=extract --mode=root \
    --include=libpng-dev,libxxhash-dev,libstdc++-12-dev,libgomp1,libcli11-dev,nlohmann-json3-dev \
    bookworm "$AARCH64_SYSROOT"
fi
cmake -S . -B build/aarch64 --toolchain "$PWD/cmake/aarch64.cmake" -D CMAKE_BUILD_TYPE=Release
cmake --build build/aarch64 --parallel "$(nproc)" --target fluidymation
file -b build/aarch64/fluidymation | grep -q 'ARM aarch64' || {
  echo "test_aarch64.sh: build/aarch64/fluidymation is no program for ARM" >&2
  exit 1
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
paint() { # FOLDER COMMAND...
  local folder=$1
  shift
  "$@" --src-path samples/source/rust/rgb/%05d.png --src-mask-path samples/source/rust/mask/%05d.png \
    --src-frames 8 --target-path samples/target-mask/jump/%05d.png --target-frames 3 --target-scale 0.5 \
    --out-path "$work/$folder/%05d.png" --quiet
}
paint here "$tool"
paint arm qemu-aarch64 -L "$AARCH64_SYSROOT" build/aarch64/fluidymation
diff -r --exclude=.fluidymation --exclude=fluidymation.json "$work/here" "$work/arm"
echo "$(find "$work/arm" -name '0*.png' | wc -l) frames painted on ARM are, byte for byte, those painted here"

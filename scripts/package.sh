#!/usr/bin/env bash
# Builds Debian packages of the tool (fluidymation) and of the engine (libfluidymation-dev).
# Usage: scripts/package.sh [FOLDER]       (default: dist)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
take_no_options "$@"
[ $# -le 1 ] || refuse "$# arguments; wanted at most FOLDER"
folder=${1:-dist}
require_own_folders

scripts/install_packages.sh build package
cmake --preset release
cmake --build --preset release --parallel "$(nproc)"
mkdir -p "$folder"
# A user's umask would go into the packages.
(umask 022 && cpack --config build/release/CPackConfig.cmake -G DEB -B "$folder")
rm -rf "$folder/_CPack_Packages"

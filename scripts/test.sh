#!/usr/bin/env bash
# Installs what is needed, builds and passes all tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
require_own_folders
scripts/install_packages.sh build samples test
cmake --preset dev
cmake --build --preset dev --parallel "$(nproc)"
ctest --preset dev --parallel "$(nproc)"

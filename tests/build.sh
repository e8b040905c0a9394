#!/usr/bin/env bash
# Installs what the tests need and builds everything, without running it: what tests/run.sh does first, and what tests/oclgrind.sh and tests/rusticl.sh build on.
#   bash tests/build.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}"
build_release all -DTYNDALL_TESTS=ON -DTYNDALL_OPENVDB=ON

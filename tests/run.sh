#!/usr/bin/env bash
# Command two of two on a fresh Debian 12 (as root, or with sudo): installs what is missing, builds, and runs every default test.
#   bash tests/run.sh [ctest options]          for example  bash tests/run.sh -R Equiangular
# The slow tests are left out; `ctest --preset release -L slow` runs them afterwards. Exit code: ctest's.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"

install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}"
build_release all -DTYNDALL_TESTS=ON -DTYNDALL_OPENVDB=ON
cd "$repository_root"
exec ctest --preset release --label-exclude slow --parallel "$(nproc)" "$@"

#!/usr/bin/env bash
# Compares Intel's OpenCL runtime for CPUs with PoCL: values of kernels and images at every lane width (tests/other_device), then the selftest of every case. The first run downloads 250 MB (host/cmake/intel_runtime.sh).
#   bash tests/intel.sh                         builds build/release
#   BUILD=build/dev bash tests/intel.sh         takes what is built there
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
source "$repository_root/host/cmake/intel_runtime.sh"
built=$(realpath "${BUILD:-$build_folder}")
if [[ -z ${BUILD:-} ]]; then
  install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}"
  build_release all -DTYNDALL_TESTS=ON -DTYNDALL_OPENVDB=ON
fi
use_intel_runtime
cache=$(mktemp -d)
trap 'rm -rf "$cache"' EXIT
export XDG_CACHE_HOME=$cache XDG_CONFIG_HOME=$cache
TYNDALL_OTHER_DEVICE=intel: TYNDALL_OTHER_LANES=1,4,8,16 TYNDALL_OTHER_GRID_SEGMENTS=1 timeout 1800 "$built/tests/other_device/other_device_test"
exec timeout 600 "$built/tyndall" selftest --device intel: --all-lanes

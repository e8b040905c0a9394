#!/usr/bin/env bash
# Compares another driver's device, Mesa's rusticl on llvmpipe, with the default one: values of kernels and an image (tests/other_device).
#   bash tests/rusticl.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}" "${rusticl_packages[@]}"
build_release other_device_test -DTYNDALL_TESTS=ON -DTYNDALL_OPENVDB=ON
RUSTICL_ENABLE=llvmpipe TYNDALL_OTHER_DEVICE=llvmpipe exec timeout 900 "$build_folder/tests/other_device/other_device_test"

#!/usr/bin/env bash
# Another driver's device, Mesa's rusticl on llvmpipe: compared with the default one, values of kernels and images (tests/other_device); then tests of tests/device with that driver alone.
#   bash tests/rusticl.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}" "${rusticl_packages[@]}"
for target in other_device_test pair_stage_test; do build_release "$target" -DTYNDALL_TESTS=ON -DTYNDALL_OPENVDB=ON; done
export RUSTICL_ENABLE=llvmpipe
TYNDALL_OTHER_DEVICE=llvmpipe timeout 900 "$build_folder/tests/other_device/other_device_test"
# At 1 lane, for its compiler is not done with wider ones. Left out: long programs (samplers, lobes), a million lights, and how many launches a bound makes, which is of a CPU.
OCL_ICD_VENDORS=/etc/OpenCL/vendors/rusticl.icd exec timeout 600 "$build_folder/tests/device/pair_stage_test" \
  --gtest_filter='PairStage/AtEveryLaneWidth.*/0:-*Sampler*:*Lobes*:*Million*:*Row37*:*BoundsOnLaunches*'

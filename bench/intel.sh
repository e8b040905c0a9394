#!/usr/bin/env bash
# Another compiler for the same kernels: Intel's OpenCL runtime for CPUs beside PoCL, on one core, in turns. Optional; nothing else of Tyndall needs it. The first run downloads 250 MB from PyPI
# (intel-opencl-rt, under Intel's licence) into build/intel.
#   bash bench/intel.sh [OUT]             writes OUT/intel.json and OUT/intel.md; OUT: bench/results/intel unless given
#   PROGRAM=build/dev/tyndall bash ...    takes that program instead of building build/release
#   REPETITIONS=5 LANES=8,16 bash ...     more turns (3), fewer lane widths (1,4,8,16)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
source "$repository_root/host/cmake/intel_runtime.sh"
out=${1:-$repository_root/bench/results/intel}
install_packages util-linux python3
if [[ -z ${PROGRAM:-} ]]; then
  install_packages "${build_packages[@]}"
  build_release tyndall_cli
fi
program=$(realpath "${PROGRAM:-$build_folder/tyndall}")

use_intel_runtime
mkdir -p "$out"
export XDG_CONFIG_HOME=$repository_root/build/intel/no_calibration

raw=$(mktemp -d)
trap 'rm -rf "$raw"' EXIT
core=$(taskset --cpu-list --pid $$ | sed 's/.*: //; s/[,-].*//')
for turn in $(seq "${REPETITIONS:-3}"); do
  for device in portable intel; do
    say "turn $turn: $device"
    timeout 600 taskset --cpu-list "$core" "$program" bench --device "$device:" --lanes "${LANES:-1,4,8,16}" --time 5 --json >"$raw/$device.$turn.json"
  done
done

say "selftest and a small render on both"
passed=true
timeout 600 "$program" selftest --device intel: --all-lanes --json >"$raw/selftest.json" || passed=false
for device in portable intel; do
  timeout 600 "$program" render "$repository_root/scenes/cornell_fog/scene.xml" --device "$device:" --lanes 16 --resolution 64x64 --passes 8 --progress none --output "$raw/$device.exr" >"$raw/$device.files"
done
"$program" compare "$raw/intel.exr" "$raw/portable.exr" --json >"$raw/images.json"
python3 -B "$repository_root/bench/intel.py" "$raw" "$out" "$passed"
cat "$out/intel.md"

#!/usr/bin/env bash
# Measures this machine: installs what is missing, builds, runs every benchmark and a render, and writes OUT/*.json and OUT/results.svg.
#   bash bench/run.sh [OUT]          OUT: bench/results unless given
#   BUILD=folder bash bench/run.sh   takes the programs of that build folder instead of building
#   REPETITIONS=3 bash bench/run.sh  quicker; 7 unless given
#   ONLY="pairs render" ...          renews only these results: pairs transmittance shadow_1_core shadow_2_cores build render variance effects selection scaling cold_start prediction roofline bias two_cores
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
out=${1:-$repository_root/bench/results}
repetitions=${REPETITIONS:-7}
raw=$(mktemp -d)
trap 'rm -rf "$raw"' EXIT

if [[ -z ${BUILD:-} ]]; then
  install_packages "${build_packages[@]}" libbenchmark-dev python3 binutils
  build_release all -DTYNDALL_BENCH=ON
fi
build=${BUILD:-$build_folder}

wanted() { [[ -z ${ONLY:-} || " $ONLY " == *" $1 "* ]]; }

# measure NAME PROGRAM [OPTION...]: one JSON file of all repetitions, in random order so that a disturbance of the machine meets all alike.
measure() {
  local name=$1 program=$2
  shift 2
  wanted "$name" || return 0
  say "measuring $name"
  "$build/bench/$program" "$@" --benchmark_repetitions="$repetitions" --benchmark_enable_random_interleaving=true \
    --benchmark_out="$raw/$name.json" --benchmark_out_format=json >"$raw/$name.log" 2>&1 || { cat "$raw/$name.log" >&2; return 1; }
}

measure pairs pairs
measure transmittance transmittance
measure shadow_1_core shadow --cores=1
[[ $(nproc) -lt 2 ]] || measure shadow_2_cores shadow --cores=2
measure build build
if wanted render; then
  say "measuring render"
  python3 -B "$repository_root/bench/render.py" "$build/tyndall" "$repository_root/scenes/fruit_juice/scene.xml" "$repetitions" >"$raw/render.json"
fi
python3 -B "$repository_root/bench/summarise.py" "$raw" "$out"
if wanted roofline; then
  say "counting instructions, which takes minutes"
  "$build/bench/roofline_count" >"$raw/counts.roofline"
  "$build/bench/roofline_peaks" >"$raw/peaks.roofline"
  "$build/tyndall" bench --lanes 16 --json >"$raw/bench.roofline"
  python3 -B "$repository_root/bench/roofline/roofline.py" "$raw/counts.roofline" "$raw/bench.roofline" "$raw/peaks.roofline" "$out/roofline"
fi
if wanted variance; then
  say "measuring variance"
  "$build/bench/variance" 300 400 >"$raw/variance.json"
  times=$raw/pairs.json
  [[ -e $times ]] || times=$out/variance/variance.json  # the times of an earlier run
  [[ -e $times ]] || { say "variance needs the times of pairs: ONLY=\"pairs variance\""; exit 1; }
  python3 -B "$repository_root/bench/variance.py" "$raw/variance.json" "$times" "$out/shadow_1_core.json" "$out/variance"
fi
if wanted bias; then
  say "measuring bias"
  python3 -B "$repository_root/bench/bias_slopes.py" "$build/bench/bias_slopes" "$out/bias"
fi
mkdir -p "$out/effects"
if wanted effects; then
  say "measuring effects"
  python3 -B "$repository_root/bench/effects/effects.py" "$build/tyndall" --json "$out/effects/effects.json" --svg "$out/effects/effects.svg"
fi
if wanted selection; then
  say "measuring selection"
  mkdir -p "$out/selection"
  "$build/bench/selection" --passes 4 >"$out/selection/selection.json"
fi
if wanted scaling; then
  say "measuring the number of lights"
  mkdir -p "$out/scaling"
  python3 -B "$repository_root/bench/scaling.py" "$build/tyndall" --json "$out/scaling/scaling.json" --svg "$out/scaling/scaling.svg"
fi
if wanted cold_start; then
  say "measuring cold_start"
  python3 -B "$repository_root/bench/cold_start/cold_start.py" "$build/tyndall" --json "$out/effects/cold_start.json"
  python3 -B "$repository_root/bench/cold_start/variants.py" "$build/tyndall" --json "$out/effects/variants.json"
fi
if wanted two_cores && [[ $(nproc) -gt 1 ]]; then
  say "measuring two cores"
  python3 -B "$repository_root/bench/two_cores.py" "$build/tyndall" "$build/bench/shadow" --json "$out/two_cores.json"
fi
if wanted prediction; then
  say "measuring prediction"
  python3 -B "$repository_root/bench/effects/prediction.py" "$build/tyndall" --json "$out/effects/prediction.json" || say "a prediction is off by more than a factor of two; is the machine busy?"
fi
say "results are in $out"

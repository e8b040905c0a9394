#!/usr/bin/env bash
# How many lines the tests run, of the kernels' mathematics as the host compiles it and of the host, by Clang's instrumentation:
#   bash tests/coverage.sh kernels [ctest options]     tests of mathematics, lights and volumes; exit code 1 below 90 % of the lines
#   bash tests/coverage.sh host [ctest options]        every default test
# What a device runs of the kernels is not counted. Tables go to standard output, the lines themselves to build/coverage/KIND.txt.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
cd "$repository_root"
kind=${1:-}
shift || true
case $kind in
  kernels) targets=(math_test singularities_test hard_cases_test hard_cases_properties_test grid_walk_test grid_march_test light_estimates)
           for test in tests/lights/*_test.cpp; do targets+=("$(basename "$test" .cpp)"); done
           sources=(kernels/math kernels/volumes kernels/lights) least=90
           left_out='|^(CInterface|Page|Package|House|Programs|farm)\.' ;;  # they need what is not built
  host) targets=(all) sources=(host) least=0 left_out= ;;
  *) say "say of what: bash tests/coverage.sh kernels, or host"; exit 2 ;;
esac
install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}" "${sanitizer_packages[@]}"
unset CCACHE_BASEDIR  # it would make paths relative, which the tables go by
folder=build/coverage
(cmake --preset coverage --log-level=WARNING && cmake --build --preset coverage --target "${targets[@]}") >&2
rm -rf "$folder/raw" && mkdir -p "$folder/raw"
export LLVM_PROFILE_FILE="$repository_root/$folder/raw/%m.profraw"  # every process of a program adds to one file
ctest --test-dir "$folder" --output-on-failure --label-exclude slow --exclude-regex "_NOT_BUILT\$$left_out" --parallel "$(nproc)" "$@" >&2

llvm-profdata merge --sparse --output "$folder/$kind.profdata" "$folder"/raw/*.profraw
# One "-object" for every program and library but the first.
mapfile -t programs < <(find "$folder/tests" "$folder/host" "$folder" -maxdepth 4 -type f \( -perm -u+x -o -name '*.so*' \) ! -name '*.sh' ! -name '*.py' ! -path '*/CMakeFiles/*' | sort -u)
objects=("${programs[0]}")
for program in "${programs[@]:1}"; do objects+=(-object "$program"); done
llvm-cov show "${objects[@]}" --instr-profile "$folder/$kind.profdata" "${sources[@]/#/$repository_root/}" >"$folder/$kind.txt" 2>/dev/null
llvm-cov export --format=lcov "${objects[@]}" --instr-profile "$folder/$kind.profdata" "${sources[@]/#/$repository_root/}" 2>/dev/null |
  awk -v root="$repository_root/" -v least="$least" -f tests/coverage.awk

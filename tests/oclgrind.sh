#!/usr/bin/env bash
# Runs the covering set of kernels (tests/support/kernel_variants.hpp) under Oclgrind at small odd sizes: accesses outside buffers, races, values that were never written, misuse of OpenCL.
#   bash tests/oclgrind.sh [part of a variant's name]
# Exit code 1: something was found, or a variant did not run.
#
# Debian's Oclgrind 21.10 has no --stop-errors and says nothing in its exit code: its log must be empty. Every variant has a process of its own and may be aborted at its very end, because this Oclgrind
# damages its heap when it gives a program back. Optimised code holds intrinsics that it does not know (noalias scopes, freeze); so the compiler's passes stay off. With vectors of 16 it takes
# values for unwritten that the same source writes with 1, 4 and 8: there it looks for the other errors only.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}" "${oclgrind_packages[@]}"
build_release every_variant_test -DTYNDALL_TESTS=ON -DTYNDALL_OPENVDB=ON
program=$build_folder/tests/oclgrind/every_variant_test
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT

# check VARIANT: one variant; prints nothing if all is well.
check() {
  local variant=$1 options=(--build-options "-O1 -disable-llvm-passes" --data-races --check-api --max-errors 20)
  local log=$logs/${variant//\//_}
  [[ $variant == *_lanes16_* ]] || options+=(--uninitialized)
  timeout 200 oclgrind "${options[@]}" --log "$log.log" "$program" --gtest_filter="*$variant" >"$log.out" 2>&1 || true
  if [[ -s $log.log ]]; then
    printf 'tyndall: Oclgrind on %s:\n%s\n' "$variant" "$(head -40 "$log.log")"
  elif ! grep -q '^\[  PASSED  \] 1 test' "$log.out"; then
    printf 'tyndall: %s did not run under Oclgrind:\n%s\n' "$variant" "$(tail -20 "$log.out")"
  else
    return 0
  fi
  touch "$logs/failed"
}

mapfile -t variants < <("$program" --gtest_list_tests | awk '/RunsAtOddSizes/ { print $1 }' | grep -F -- "${1:-}")
[[ ${#variants[@]} -gt 0 ]] || { say "no variant has \"${1:-}\" in its name"; exit 1; }
running=0
for variant in "${variants[@]}"; do
  if ((running == $(nproc))); then wait -n && running=$((running - 1)); fi
  check "$variant" 2>/dev/null &  # the shell would tell of every abort
  running=$((running + 1))
done
wait
[[ ! -e $logs/failed ]] || exit 1
say "${#variants[@]} variants of the kernels are clean under Oclgrind"

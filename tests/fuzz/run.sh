#!/usr/bin/env bash
# Fuzzes every reader of foreign bytes: builds the fuzzers with Clang (preset asan), then runs each for so long.
#   bash tests/fuzz/run.sh [seconds for each, 20] [target...]      for example  bash tests/fuzz/run.sh 1800 scene ply
# Without names: all but vdb, the whole of a .vdb, because Debian's OpenVDB 10.0 writes beyond its memory there (README.md); vdb_header is what is read before OpenVDB.
# New inputs that reach further are kept in build/fuzz/corpus; what breaks a promise lies in build/fuzz/findings. Exit code 3: something was found.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../host/cmake/install_and_build.sh"
seconds=${1:-20}
shift || true
targets=("$@")
[[ ${#targets[@]} -gt 0 ]] || targets=(scene obj ply vol vdb_header exr picture checkpoint shards numbers)
fuzz_folder=$repository_root/tests/fuzz
build_folder=$repository_root/build/asan
results=$repository_root/build/fuzz

install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}" "${sanitizer_packages[@]}"
cd "$repository_root"
(cmake --preset asan --log-level=WARNING && cmake --build --preset asan --target fuzzers) >&2

# Executions of a piece: what 20 s are about enough for on a core of 3.5 GHz. Seeds are numbers of pieces, so a faster machine tries the same inputs as a slower one and no others: what passes on one passes
# on the next.
declare -A most=([scene]=230000 [obj]=550000 [ply]=700000 [vol]=2500000 [vdb]=5000 [vdb_header]=2000000 [exr]=60000 [picture]=100000 [checkpoint]=180000 [shards]=145000 [numbers]=80000)

# fuzz NAME SECONDS SEED: one fuzzer, from the repository's corpus and what earlier runs have found. A fuzzer may take 2 GB, an input a minute: the largest grid that is read takes six seconds
# of a processor, which may have other work.
fuzz() {
  local target=$1 options=()
  local found=$results/corpus/$target
  mkdir -p "$found" "$results/findings"
  [[ -f $fuzz_folder/dictionaries/$target.dict ]] && options+=("-dict=$fuzz_folder/dictionaries/$target.dict")
  [[ $target == vdb ]] && options+=(-detect_leaks=0)
  "$build_folder/tests/fuzz/fuzz_$target" -max_total_time="$2" -runs="${most[$target]}" -seed="$3" -timeout=60 -rss_limit_mb=2048 -max_len=32768 -len_control=20 -print_final_stats=1 \
    -artifact_prefix="$results/findings/$target-" "${options[@]}" "$found" "$fuzz_folder/corpus/${target%_header}"
}

# run_target NAME: in pieces of 20 s, because OpenVDB leaks. Prints executions, edges of the program's graph that were reached, of how many, and inputs kept.
run_target() {
  local target=$1 left=$seconds piece=0 log=$results/$1.log
  mkdir -p "$results"
  : >"$log"
  while ((left > 0)); do
    if ! fuzz "$target" $((left < 20 ? left : 20)) $((++piece)) 2>>"$log"; then
      grep -aE 'ERROR|SUMMARY|broken promise|terminate|what\(\)|runtime error|Test unit written' "$log" >&2 || tail -20 "$log" >&2
      printf '%-12s found something: see %s\n' "$target" "$log"
      return 1
    fi
    left=$((left - 20))
  done
  awk -v target="$target" '/Loaded 1 modules/ { match($0, /\(([0-9]+) inline/); all = substr($0, RSTART + 1, RLENGTH - 8) }
    { for (i = 1; i < NF; ++i) if ($i == "cov:") reached = $(i + 1); if ($2 == "DONE") for (i = 1; i < NF; ++i) if ($i == "corp:") kept = $(i + 1) }
    /number_of_executed_units/ { runs += $2 } END { printf "%-12s %9d executions, %5d of %d edges, %s inputs kept\n", target, runs, reached, all, kept }' "$log"
}

# As many at a time as there are processors.
failed=0 running=0
for target in "${targets[@]}"; do
  if ((running == $(nproc))); then
    wait -n || failed=1
    running=$((running - 1))
  fi
  run_target "$target" &
  running=$((running + 1))
done
for (( ; running > 0; --running)); do wait -n || failed=1; done
exit $((failed ? 3 : 0))

#!/usr/bin/env bash
# Runs tests of the host under sanitizers, with Clang:
#   bash tests/sanitize.sh asan [ctest options]    AddressSanitizer, its check for leaks, and UndefinedBehaviorSanitizer with conversions of numbers that do not fit
#   bash tests/sanitize.sh ubsan [ctest options]   UndefinedBehaviorSanitizer alone, the same tests: where the memory that AddressSanitizer takes is not there
#   bash tests/sanitize.sh tsan [ctest options]    ThreadSanitizer
# Kernels are compiled by the driver and are not instrumented: tests/oclgrind.sh looks after them. Debian's libraries are not instrumented either: tests/sanitize/*.txt say what follows. Exit code: ctest's.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
sanitizer=${1:-}
shift || true
# Programs that are not built; and what runs the same lines thousands of times, longer than all else together: statistics, the sweep over every OpenCL call.
left_out='_NOT_BUILT$|^(Page|Package|farm|House)\.|^CInterface\.FromPython$|^ErrorUpperBound\.Holds|^TargetError\.IsNotReachedByLuck|^MediumLine\.DepthIsTheIntegral|SamplesFollow|EveryCall\.'
chosen=()
case $sanitizer in
  asan | ubsan)
    # Every program of tests whose own process reads, writes, traces and calls devices. Left out: whole renders that are compared with others (pipeline, images), mathematics (which the fast build tests),
    # and what runs the program tyndall or a browser.
    programs=(exr_header_test scene_test openvdb_test no_openvdb_test shipped_scenes_test fuzz_corpus_test test_film test_report test_cli_parts test_support test_metrics
              test_visibility test_volumes test_transport device_list_test test_faults test_library test_library_backend tyndall_from_c planted_errors) ;;
  tsan)
    # What renders with several threads, several devices, twice at once.
    programs=(test_threads test_faults planted_errors)
    chosen=(--tests-regex 'Sameness|ForAnyThreads|NumberOfThreads|SeveralDevices|TheOtherDevice|^PlantedError') ;;
  *) say "say which: bash tests/sanitize.sh asan, ubsan or tsan"; exit 2 ;;
esac
install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}" "${sanitizer_packages[@]}"
cd "$repository_root"

suppressions=$repository_root/tests/sanitize
export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:detect_stack_use_after_return=1:check_initialization_order=1
export LSAN_OPTIONS=suppressions=$suppressions/leaks.txt:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS=suppressions=$suppressions/races.txt:ignore_noninstrumented_modules=1:history_size=4:second_deadlock_stack=1:print_suppressions=0
symbolizer=$(command -v llvm-symbolizer)
export ASAN_SYMBOLIZER_PATH=$symbolizer TSAN_SYMBOLIZER_PATH=$symbolizer UBSAN_SYMBOLIZER_PATH=$symbolizer
# Mesa's Clover is unloaded before the check for leaks, so that what it leaks has no name that leaks.txt could give: PoCL alone, where Debian puts it.
pocl=/etc/OpenCL/vendors/pocl.icd
if [[ -f $pocl ]]; then export OCL_ICD_VENDORS=${OCL_ICD_VENDORS:-$pocl}; fi
alone=()
if setarch -R true 2>/dev/null; then alone=(setarch -R); fi  # ThreadSanitizer's memory has fixed places: addresses stay where it expects them
("${alone[@]}" cmake --preset "$sanitizer" --log-level=WARNING && "${alone[@]}" cmake --build --preset "$sanitizer" --target "${programs[@]}") >&2
exec "${alone[@]}" ctest --test-dir "build/$sanitizer" --output-on-failure --label-exclude slow --exclude-regex "$left_out" "${chosen[@]}" --parallel "$(nproc)" "$@"

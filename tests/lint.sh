#!/usr/bin/env bash
# Asks compilers and checkers about the text, which they do not run: kernels as OpenCL C by Clang, the host's sources by clang-tidy and cppcheck, their form by clang-format.
#   bash tests/lint.sh [kernels] [tidy] [cppcheck] [format]      these parts, or all
#   bash tests/lint.sh --all kernels                             kernels of the full product of light, kind of eye, feature, precision and lanes; without --all the covering set and the scenes' own
#   bash tests/lint.sh --write format                            brings the sources into form
# host/docs/ci.md says what each part asks and leaves out. Exit code: 0 if nothing was found, 1 if something was.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
all=() write=() parts=()
for argument in "$@"; do
  case $argument in
    --all) all=(--all) ;;
    --write) write=(--write) ;;
    kernels | tidy | cppcheck | format) parts+=("$argument") ;;
    *) say "no part \"$argument\"; there are kernels, tidy, cppcheck and format"; exit 2 ;;
  esac
done
[[ ${#parts[@]} -gt 0 ]] || parts=(kernels tidy cppcheck format)
install_packages "${build_packages[@]}" "${optional_packages[@]}" "${test_packages[@]}" "${lint_packages[@]}"
cd "$repository_root"
processors=$(nproc)
folder=$repository_root/build/lint
mkdir -p "$folder"

lint_kernels() {
  build_release write_kernels -DTYNDALL_TESTS=ON -DTYNDALL_OPENVDB=ON || return
  rm -rf "$folder/kernels"
  "$build_folder/tests/lint/write_kernels" "$folder/kernels" "${all[@]}" >&2 || return
  (cd "$folder/kernels" && xargs -P "$processors" -L 1 "$repository_root/tests/lint/kernel.sh" <builds)
}

# What the two checkers of C++ read: the compiler's commands, without what Clang does not know, for the host's own sources.
host_commands() {
  build_release tyndall_cli -DTYNDALL_TESTS=ON -DTYNDALL_OPENVDB=ON || return  # for the sources that the build writes
  python3 tests/lint/host_commands.py "$build_folder/compile_commands.json" "$repository_root/host" "$folder/compile_commands.json"
}

lint_tidy() {
  host_commands | xargs -P "$processors" -n 1 clang-tidy -p "$folder" --quiet --warnings-as-errors='*' 2> >(grep -v 'warnings generated\|warnings treated as errors' >&2)
}

lint_cppcheck() {
  host_commands >"$folder/sources" || return
  cppcheck --project="$folder/compile_commands.json" -j "$processors" --quiet --inline-suppr --error-exitcode=1 --std=c++20 --enable=warning,performance,portability \
    --suppressions-list=tests/lint/cppcheck.txt
}

lint_format() {
  git ls-files -z '*.cpp' '*.hpp' | xargs -0 python3 -B tests/lint/form.py clang-format-16 "${write[@]}"
}

failed=0
for part in "${parts[@]}"; do
  if "lint_$part"; then say "$part: nothing was found"; else say "$part: something was found"; failed=1; fi
done
exit $failed

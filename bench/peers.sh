#!/usr/bin/env bash
# Tyndall beside Mitsuba 3 on the same scenes, one core each, in turns: bash bench/peers.sh [PROGRAM] [OUT]
# Optional: installs Mitsuba from PyPI (some 100 MB) into a virtual environment under build/, and the LLVM that it compiles with. SECONDS_EACH=3 ROUNDS=3 by default: some 25 minutes.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
program=${1:-$build_folder/tyndall}
out=${2:-$repository_root/bench/results/peers}
venv=${VENV:-$repository_root/build/peers-venv}

if [[ ! -x $program ]]; then
  install_packages "${build_packages[@]}"
  build_release all
fi
install_packages python3-venv libllvm19
if [[ ! -x $venv/bin/python3 ]]; then
  say "installing Mitsuba into $venv"
  python3 -m venv "$venv"
  "$venv/bin/pip" install --quiet mitsuba==3.9.1 numpy openexr
fi
export DRJIT_LIBLLVM_PATH=${DRJIT_LIBLLVM_PATH:-$(ldconfig -p | sed -n 's|.*=> \(.*/libLLVM\.so\.19.*\)|\1|p' | head -1)}
mkdir -p "$out"
"$venv/bin/python3" -B "$repository_root/bench/peers.py" "$program" --seconds "${SECONDS_EACH:-3}" --rounds "${ROUNDS:-3}" --json "$out/peers.json" --markdown "$out/peers.md"
say "results are in $out"

#!/usr/bin/env bash
# The experiments of the SIGGRAPH 2012 talk on virtual ray lights, at equal time on this machine:
#   bash bench/talk.sh [--quick] [--only juice,room,surfaces,animation] [OUT]      OUT: out/talk unless given
# --quick divides all times by ten (some 20 minutes; two hours and a half without). It goes on where it was interrupted: what OUT holds already is not rendered again.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"
if [[ -z ${PROGRAM:-} ]]; then
  install_packages "${build_packages[@]}" python3
  build_release all
fi
exec python3 -B "$repository_root/bench/talk.py" "${PROGRAM:-$build_folder/tyndall}" "$@"

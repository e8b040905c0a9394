#!/usr/bin/env bash
# The tests that need device programs beyond those of the default tests: other lane widths, samplers, features, media, shipped scenes (tests/programs/variants.cmake).
#   bash tests/variants.sh [ctest options]          for example  bash tests/variants.sh -R GridPairs
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
bash "$root/tests/build.sh"
cd "$root"
exec ctest --preset release --label-regex variants --parallel "$(nproc)" "$@"

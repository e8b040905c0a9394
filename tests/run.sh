#!/usr/bin/env bash
# Command two of two on a fresh Debian 12 (as root, or with sudo): installs what is missing, builds, and runs every default test.
#   bash tests/run.sh [ctest options]          for example  bash tests/run.sh -R Equiangular
# Left out are tests that need device programs of their own (`ctest --preset release -L variants`) and slow ones (`-L slow`). Exit code: ctest's.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
bash "$root/tests/build.sh"
cd "$root"
exec ctest --preset release --label-exclude "slow|variants" --parallel "$(nproc)" "$@"

#!/usr/bin/env bash
# Command one of two on a fresh Debian 12 (as root, or with sudo): installs what is missing, builds the program, renders a picture.
#   bash scenes/render.sh [scene folder] [render options]
#   bash scenes/render.sh                                    the fruit juice, on the default device
#   bash scenes/render.sh cornell_fog --passes 64            another scene, other options (build/release/tyndall render --help)
# Writes out/<scene>.exr, .png and .json in the repository (with -o FILE.exr: there) and says so. Exit code: the renderer's.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../host/cmake/install_and_build.sh"

scene=$repository_root/scenes/fruit_juice
if [[ $# -gt 0 && $1 != -* ]]; then
  scene=$1
  [[ -d $scene ]] || scene=$repository_root/scenes/$1
  shift
fi
[[ $# -gt 0 ]] || set -- --passes 48  # a minute or two on two cores; options of your own replace this
if [[ ! -f $scene/scene.xml ]]; then
  say "$scene/scene.xml: no such scene; there are: $(cd "$repository_root/scenes" && echo */ | tr -d /)"
  exit 3
fi
scene="$(cd "$scene" && pwd -P)"
image=$repository_root/out/$(basename "$scene").exr

install_packages "${build_packages[@]}"
build_release tyndall_cli
for option in "$@"; do
  case $option in
    -o | -o?* | --output | --output=*) exec "$build_folder/tyndall" render "$scene/scene.xml" "$@" ;;
  esac
done
mkdir -p "$repository_root/out"
"$build_folder/tyndall" render "$scene/scene.xml" --output "$image" "$@" >/dev/null
say "image with all layers: $image"
say "picture to look at:    ${image%.exr}.png"
say "report:                ${image%.exr}.json"

#!/usr/bin/env bash
# The documents as a site, build/site/html/index.html, with Debian's mkdocs. Fails if a link in it leads nowhere, to a page or to a place on a page, or a page is in no menu.
#   bash host/docs/site.sh [FOLDER]          into FOLDER/html
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/install_and_build.sh"
command -v mkdocs >/dev/null || install_packages python3 "${site_packages[@]}"
site=${1:-$repository_root/build/site}
python3 -B "$repository_root/host/docs/site.py" stage "$repository_root" "$site"
mkdocs build --quiet --clean --config-file "$site/mkdocs.yml"
python3 -B "$repository_root/host/docs/site.py" check "$site/html"

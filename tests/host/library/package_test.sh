#!/usr/bin/env bash
# package_test.sh CPACK BUILD_FOLDER SCENE [clean]: makes the Debian package, unpacks it and runs what is in it; with `clean`, installs it into a fresh Debian (as root,
# with debootstrap and the mirror that apt uses here) and renders there, on PoCL. Exit code 77: something that the test itself needs is missing.
set -euo pipefail
cpack=$1 build=$2 scene=$3 mode=${4:-unpack}
skip() { printf 'skipped: %s\n' "$*"; exit 77; }
fail() { printf 'failed: %s\n' "$*" >&2; exit 1; }
for tool in dpkg-deb dpkg-shlibdeps file; do command -v "$tool" >/dev/null || skip "there is no $tool"; done

folder=$(mktemp -d)
clean_up() {
  local code=$?
  for mounted in proc dev sys; do mountpoint --quiet "$folder/root/$mounted" && umount "$folder/root/$mounted"; done
  rm -rf --one-file-system "$folder"
  exit "$code"
}
trap clean_up EXIT

(cd "$build" && "$cpack" -G DEB -B "$folder/package") >"$folder/cpack.log" 2>&1 || { cat "$folder/cpack.log"; fail "cpack"; }
package=$(echo "$folder"/package/*.deb)
depends=$(dpkg-deb --field "$package" Depends)
for library in libembree libopenexr libtbb ocl-icd-libopencl1; do [[ $depends == *$library* ]] || fail "the package does not depend on $library: $depends"; done
[[ $depends != *-dev* ]] || fail "the package depends on something to develop with: $depends"

if [[ $mode == unpack ]]; then
  dpkg-deb --extract "$package" "$folder/root"
  "$folder/root/usr/bin/tyndall" --version | grep "^tyndall $(dpkg-deb --field "$package" Version) " || fail "the program does not have the package's version"
  "$folder/root/usr/bin/tyndall" render "$scene" --resolution 8x8 -p 1 --lights 16 --no-selftest --progress none -o "$folder/small.exr" || fail "rendering"
  exit 0
fi

[[ $(id -u) -eq 0 ]] || skip "installing into a fresh Debian takes root"
command -v debootstrap >/dev/null || skip "there is no debootstrap"
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
mirror=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' | awk -v suite="$suite" '$2 == suite {print $1; exit}')
[[ $mirror == http* ]] || skip "apt has no mirror of $suite that debootstrap could use"
debootstrap --variant=minbase "$suite" "$folder/root" "$mirror" >"$folder/debootstrap.log" 2>&1 || { tail -5 "$folder/debootstrap.log"; skip "debootstrap failed"; }
mount -t proc proc "$folder/root/proc" && mount --bind /dev "$folder/root/dev" && mount --bind /sys "$folder/root/sys"  # PoCL counts cores there
cp /etc/resolv.conf "$folder/root/etc/"
cp "$package" "$folder/root/tyndall.deb"
cp "$scene" "$folder/root/scene.xml"
in_root() { env --unset=XDG_CACHE_HOME HOME=/root DEBIAN_FRONTEND=noninteractive chroot "$folder/root" "$@"; }
in_root apt-get update --quiet --quiet || fail "apt-get update"
in_root apt-get install --yes --quiet --quiet --no-install-recommends /tyndall.deb pocl-opencl-icd || fail "apt-get install"
in_root tyndall devices | grep -i pocl || fail "the installed program sees no device"
in_root tyndall render scene.xml --resolution 8x8 -p 2 --lights 16 -o small.exr || fail "rendering in the fresh Debian"
[[ -s $folder/root/small.exr ]] || fail "no image"
in_root ldconfig -p | grep libtyndall.so.0 || fail "the dynamic linker does not find the library"
in_root dpkg --remove tyndall >/dev/null || fail "removing it"
[[ ! -e $folder/root/usr/bin/tyndall ]] || fail "something is left after it was removed"

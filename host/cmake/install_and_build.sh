# Shared by scenes/render.sh and tests/run.sh, which source it: what Tyndall needs from Debian 12, and how it is built.
# Sets repository_root; defines install_packages and build_release. Everything it says goes to standard error.

repository_root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)"
build_folder="$repository_root/build/release"

build_packages=(
  cmake g++ ninja-build pkg-config git
  ocl-icd-opencl-dev opencl-clhpp-headers pocl-opencl-icd   # OpenCL: loader, C++ bindings, and a device that runs on any CPU
  libembree-dev libtbb-dev                                  # ray tracing on the host
  libopenexr-dev libpng-dev                                 # images
  libglm-dev libboost-dev                                   # host mathematics, small containers
  libpugixml-dev                                            # scenes
  nlohmann-json3-dev libcli11-dev libfmt-dev                # reports, command line, messages
)
optional_packages=(libopenvdb-dev)                          # .vdb files; tests/run.sh installs it, so that they are tested
test_packages=(libgtest-dev libgmock-dev librapidcheck-dev python3 python3-numpy dpkg-dev file
               mkdocs                                       # the documents as a site, host/docs/site.sh
               locales                                      # one with a decimal comma, made by tests/support/comma_locale.hpp
               chromium chromium-driver)                    # the page of `tyndall compare`
sanitizer_packages=(clang libclang-rt-dev llvm)             # tests/sanitize.sh, tests/fuzz, tests/coverage.sh: the runtimes, libFuzzer among them, and names for addresses in llvm
oclgrind_packages=(oclgrind)                                # tests/oclgrind.sh
rusticl_packages=(mesa-opencl-icd)                          # tests/rusticl.sh
site_packages=(mkdocs)                                      # host/docs/site.sh
lint_packages=(clang clang-tidy cppcheck clang-format-16)   # tests/lint.sh

say() { printf 'tyndall: %s\n' "$*" >&2; }

# as_root COMMAND...: runs it as root, through sudo where we are not.
as_root() {
  if [[ $(id -u) -eq 0 ]]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    say "installing packages needs root, and there is no sudo: run this once as root, or install them yourself"
    return 1
  fi
}

# install_packages NAME...: installs those that are missing, after saying which. Touches nothing when none is.
install_packages() {
  local package missing=()
  for package in "$@"; do
    [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
  done
  if [[ ${#missing[@]} -eq 0 ]]; then
    say "every Debian package that is needed is installed"
    return 0
  fi
  say "installing ${#missing[@]} Debian packages and what they depend on: ${missing[*]}"
  as_root apt-get update --quiet >&2 || return
  as_root apt-get install --yes --quiet --no-install-recommends "${missing[@]}" </dev/null >&2
}

# build_release TARGET [CMAKE OPTION...]: configures the preset "release" and builds one target of it.
# A build folder that exists keeps its options, apart from those given here.
build_release() {
  local target=$1
  shift
  local options=("$@")
  [[ -f $build_folder/CMakeCache.txt ]] || options=(-DTYNDALL_TESTS=OFF -DTYNDALL_BENCH=OFF "${options[@]}")
  say "building $target in $build_folder"
  (cd "$repository_root" && cmake --preset release --log-level=WARNING "${options[@]}" && cmake --build "$build_folder" --target "$target") >&2
}

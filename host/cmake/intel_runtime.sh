# Intel's OpenCL runtime for CPUs, for bench/intel.sh and tests/intel.sh, which source this after install_and_build.sh. Optional; nothing else of Tyndall needs it.
# Defines use_intel_runtime.

# use_intel_runtime: installs the runtime into build/intel, unless it is there (250 MB from PyPI: intel-opencl-rt, under Intel's licence), and lets the loader find it and PoCL: sets OCL_ICD_VENDORS and
# LD_LIBRARY_PATH.
use_intel_runtime() {
  local folder=$repository_root/build/intel
  install_packages python3 python3-venv
  if [[ ! -e $folder/venv/lib/libintelocl.so ]]; then
    say "installing Intel's runtime into $folder"
    python3 -m venv "$folder/venv"
    timeout 600 "$folder/venv/bin/pip" install --quiet intel-opencl-rt intel-cmplr-lib-rt
  fi
  # Intel's needs a newer TBB than Debian's, which the program has loaded already: that one library goes first on the path, and none else of its folder, which also holds a libOpenCL.so that would take the
  # place of the system's loader.
  mkdir -p "$folder/vendors" "$folder/libraries"
  echo "$folder/venv/lib/libintelocl.so" >"$folder/vendors/intel.icd"
  cp /etc/OpenCL/vendors/pocl.icd "$folder/vendors/"
  ln -sf "$folder/venv/lib/libtbb.so.12" "$folder/libraries/"
  export OCL_ICD_VENDORS=$folder/vendors LD_LIBRARY_PATH=$folder/libraries
}

#pragma once
#include <string>

namespace tyndall {

/// "0.1.0 (1234abc)": version and commit; "-dirty" marks a working tree with changes, "unknown" a source tree without git.
std::string version();

/// "0.1.0".
std::string version_number();

/// What `--version` prints: version, commit, compiler, the OpenCL loader that the program runs with, which is `loader` ("": it does not say; then the version of the headers, and that), and the libraries that it was built with, a line each.
std::string version_text(const std::string& loader);

}  // namespace tyndall

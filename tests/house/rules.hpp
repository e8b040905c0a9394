#pragma once
/// The house rules. Each takes the root of a repository and returns its violations, one sentence each, "path:line: what is wrong"; none is good.
#include <string>
#include <vector>

#include "source_tree.hpp"

namespace tyndall::house {

using Violations = std::vector<std::string>;

/// Includes go one way (README.md, "Layout"): a file includes from its own row or a row above, and the four parts in the middle row never each other.
Violations includes_against_the_direction(const fs::path& root);

/// OpenCL stays in host/device (and in an example with a queue of its own), Embree in host/visibility, OpenEXR and PNG in host/film and host/exr, pugixml and tinyobjloader in host/scene, CLI11 in host/cli;
/// kernels/ includes no library at all. tests/ and bench/ are free.
Violations libraries_outside_their_folder(const fs::path& root);

/// What a header of host/include includes, directly or through other headers, is neither OpenCL nor Embree nor OpenEXR nor GLM.
Violations libraries_in_public_headers(const fs::path& root);

/// Sources have at most 300 lines, CMake files fewer than 100.
Violations files_too_long(const fs::path& root);

/// Functions have at most 40 lines, signature and braces included.
Violations functions_too_long(const fs::path& root);

/// kernels/ asks `if (FEATURE)`: the preprocessor decides only in the dialect, in include guards and in defaults of build options.
Violations conditional_compilation_in_kernels(const fs::path& root);

/// No `native_` or `half_` functions in kernels/, no compiler option anywhere that lets arithmetic be reordered or approximated.
Violations approximate_arithmetic(const fs::path& root);

/// The repository's root holds what the house plan names, dot-files, and the two folders that git ignores (build, out).
Violations strangers_at_the_top(const fs::path& root);

/// Relative links in Markdown files, and paths between backticks in README files that start with a folder of the house, lead to something.
Violations dead_links(const fs::path& root);

/// Every page of host/docs is linked from host/docs/README.md.
Violations pages_that_nobody_finds(const fs::path& root);

/// Every `Suite.Test` that host/docs/faults.md names is a test.
Violations tests_that_are_not_there(const fs::path& root);

/// Every type and parameter that the readers of host/scene ask for stands in host/docs/scenes.md.
Violations elements_without_a_page(const fs::path& root);

/// CITATION.cff and the newest heading of host/docs/changelog.md name the version of CMakeLists.txt.
Violations versions_that_differ(const fs::path& root);

/// Every folder in scenes/ holds scene.xml and README.md, and its meshes are what its make_geometry.py writes, byte for byte.
Violations scenes_not_reproduced(const fs::path& root);

}  // namespace tyndall::house

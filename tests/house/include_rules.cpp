#include <map>
#include <optional>
#include <regex>
#include <set>

#include "rules.hpp"

namespace tyndall::house {
namespace {

struct Include {
    std::string name;
    bool quoted = false;
    std::size_t line = 0;
};

std::vector<Include> includes_of(const SourceFile& file)
{
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<Include> found;
    for (std::size_t i = 0; i < file.code.size(); ++i) {
        std::smatch match;
        if (std::regex_search(file.code[i], match, pattern)) found.push_back({match[2], match[1] == "\"", i});
    }
    return found;
}

/// A row of the house, a folder or a file of it; a higher number may include a lower one. `alone`: parts of the same row must not include each other.
struct Row {
    std::string_view folder;
    int number;
    bool alone = false;
};

constexpr Row rows[] = {
    {"kernels/dialect.h", 0},
    {"kernels/shared/", 1},
    {"kernels/math/", 2},
    {"kernels/volumes/", 3},
    {"kernels/lights/", 4},
    {"kernels/stages/", 5},
    {"kernels/selftest/", 5},
    {"kernels/baseline/", 5},
    {"kernels/dialect_host.hpp", 5},      // all of the mathematics as C++
    {"kernels/embedded_kernels.hpp", 5},  // all of the kernels as text
    {"host/include/", 6},
    {"host/parallel/", 6},                // loops over threads
    {"host/exr/", 6},
    {"host/scene/", 6},
    {"host/volumes/", 7},
    {"host/device/", 8, true},
    {"host/visibility/", 8, true},
    {"host/film/", 8, true},
    {"host/report/", 8, true},
    {"host/metrics/", 9},
    {"host/transport/", 9},
    {"host/lights/", 10},
    {"host/light_tracing/", 10},
    {"host/eye_tracing/", 10},
    {"host/tiling/", 10},
    {"host/path_tracing/", 10},
    {"host/photon_map/", 10},
    {"host/selftest/", 10},
    {"host/throughput/", 10},
    {"host/pipeline/", 11},
    {"host/comparison/", 12},
    {"host/cli/", 13},
    {"host/library/", 13},
    {"host/examples/", 14},
    {"tests/", 14},
    {"bench/", 14},
};

std::optional<Row> row_of(const std::string& path)
{
    for (const Row& row : rows)
        if (row.folder.ends_with('/') ? path.starts_with(row.folder) : path == row.folder) return row;
    return std::nullopt;
}

/// Path of an include inside the repository, looked for as the compilers do; nothing if it is a library's or the build's.
std::optional<std::string> resolve(const fs::path& root, const SourceFile& from, const Include& include)
{
    const fs::path own_folder = fs::path(from.path).parent_path();
    for (const fs::path& base : {own_folder, fs::path("host"), fs::path("host/include"), fs::path("."), fs::path("kernels"), fs::path("tests")}) {
        const fs::path candidate = (base / include.name).lexically_normal();
        if (fs::is_regular_file(root / candidate)) return candidate.generic_string();
    }
    return std::nullopt;
}

struct Library {
    const char* name;
    const char* pattern;
    std::vector<std::string_view> homes;  ///< folders of host/ that may include it
};

const std::vector<Library>& libraries()
{
    static const std::vector<Library> all = {
        {"OpenCL", R"(^CL/|^OpenCL/)", {"host/device/", "host/examples/photons.cpp"}},
        {"Embree", R"(^embree[0-9]*/)", {"host/visibility/"}},
        {"TBB", R"(^tbb/|^oneapi/tbb)", {"host/parallel/", "host/visibility/embree_scene.hpp", "host/pipeline/render.cpp"}},
        {"OpenEXR", R"(^OpenEXR/|^Imath/|^Imf|^half\.h$)", {"host/exr/", "host/film/", "host/scene/picture_exr.cpp"}},
        {"PNG", R"(^png\.h$)", {"host/film/", "host/scene/picture_png.cpp"}},
        {"pugixml", R"(^pugixml)", {"host/scene/"}},
        {"tinyobjloader", R"(^tiny_obj_loader)", {"host/scene/"}},
        {"OpenVDB", R"(^openvdb/)", {"host/scene/volume_vdb.cpp"}},
        {"CLI11", R"(^CLI/|^CLI11)", {"host/cli/"}},
        {"GLM", R"(^glm/)", {"host/"}},
    };
    return all;
}

const Library* library_of(const Include& include)
{
    for (const Library& library : libraries())
        if (std::regex_search(include.name, std::regex(library.pattern))) return &library;
    return nullptr;
}

void check_direction(const fs::path& root, const SourceFile& file, const Row& own, Violations& found)
{
    for (const Include& include : includes_of(file)) {
        const auto target = resolve(root, file, include);
        if (!target) continue;
        const auto other = row_of(*target);
        if (!other) {
            found.push_back(violation(file, include.line, *target + " is in no row of the house"));
        } else if (other->number > own.number) {
            found.push_back(violation(file, include.line, "includes " + *target + ", which is further down the house"));
        } else if (own.alone && other->number == own.number && other->folder != own.folder) {
            found.push_back(violation(file, include.line, "includes " + *target + ": device, visibility, film and report never include each other"));
        }
    }
}

bool at_home(const std::string& path, const Library& library)
{
    for (std::string_view home : library.homes)
        if (path.starts_with(home)) return true;
    return false;
}

}  // namespace

Violations includes_against_the_direction(const fs::path& root)
{
    Violations found;
    for (const SourceFile& file : read_sources(root)) {
        if (const auto own = row_of(file.path))
            check_direction(root, file, *own, found);
        else
            found.push_back(file.path + ": is in no row of the house; tests/house/include_rules.cpp lists the rows");
    }
    return found;
}

Violations libraries_outside_their_folder(const fs::path& root)
{
    Violations found;
    for (const SourceFile& file : read_sources(root)) {
        if (file.path.starts_with("tests/") || file.path.starts_with("bench/")) continue;
        for (const Include& include : includes_of(file)) {
            const Library* library = library_of(include);
            if (library && !at_home(file.path, *library))
                found.push_back(violation(file, include.line, std::string(library->name) + " stays in " + std::string(library->homes.front())));
        }
    }
    return found;
}

Violations libraries_in_public_headers(const fs::path& root)
{
    std::map<std::string, SourceFile> by_path;
    for (SourceFile& file : read_sources(root)) by_path.emplace(file.path, file);
    std::set<std::string> seen;
    std::vector<std::string> waiting;
    for (const auto& [path, file] : by_path)
        if (path.starts_with("host/include/")) waiting.push_back(path);
    Violations found;
    while (!waiting.empty()) {
        const std::string path = waiting.back();
        waiting.pop_back();
        if (!seen.insert(path).second) continue;
        const SourceFile& file = by_path.at(path);
        for (const Include& include : includes_of(file)) {
            if (const Library* library = library_of(include))
                found.push_back(violation(file, include.line, std::string("a public header reaches ") + library->name));
            const auto target = resolve(root, file, include);
            if (target && by_path.contains(*target)) waiting.push_back(*target);
        }
    }
    return found;
}

}  // namespace tyndall::house

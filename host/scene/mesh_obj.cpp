// Wavefront OBJ.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

#include "scene/mesh_files.hpp"
#include "scene/text.hpp"

namespace tyndall {

namespace {

using Corner = std::array<std::int64_t, 3>;  ///< position, texture coordinate, normal; from 0, -1: not given

struct CornerHash {
    std::size_t operator()(const Corner& c) const
    {
        std::uint64_t h = 0;
        for (const std::int64_t part : c) h = (h ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
        return static_cast<std::size_t>(h);
    }
};

class ObjReader {
public:
    MeshFile read(std::string_view bytes)
    {
        while (!bytes.empty()) {
            const std::size_t end = std::min(bytes.find('\n'), bytes.size());
            ++line_;
            const std::string_view line = bytes.substr(0, end);
            read_line(line.substr(0, line.find('#')));
            bytes.remove_prefix(std::min(end + 1, bytes.size()));
        }
        MeshFile file{.mesh = std::move(mesh_)};
        if (!all_normals_ && !normals_.empty()) file.remarks.emplace_back("some corners have no normal: face normals are used everywhere");
        if (!all_normals_) file.mesh.normals.clear();
        if (!all_uvs_) file.mesh.uvs.clear();
        finish_mesh(file, concave_);
        return file;
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw MeshFault(fmt::format("line {}: {}", line_, message)); }

    void read_line(std::string_view line)
    {
        // tabs and blanks only: a comma is no separator here
        words_.clear();
        constexpr std::string_view blanks = " \t\r";
        for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
            const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
            words_.push_back(line.substr(at, end - at));
            at = line.find_first_not_of(blanks, end);
        }
        if (words_.empty()) return;
        const std::string_view key = words_[0];
        if (key == "v") return positions_.push_back(vector_of<Vec3>(3, 7));
        if (key == "vn") return normals_.push_back(vector_of<Vec3>(3, 3));
        if (key == "vt") return uvs_.push_back(vector_of<Vec2>(2, 3));
        if (key == "f") return read_face();
        constexpr std::array<std::string_view, 18> passed_over{"o",        "g",        "s",          "mg",        "usemtl", "mtllib",
                                                               "usemap",   "maplib",   "l",          "p",         "lod",    "bevel",
                                                               "c_interp", "d_interp", "shadow_obj", "trace_obj", "vp",     "end"};
        if (std::find(passed_over.begin(), passed_over.end(), key) == passed_over.end())
            fail(in_quotes(key) + " is not supported; Tyndall reads v, vn, vt and f");
    }

    template <class Vector>
    Vector vector_of(std::size_t least, std::size_t most) const
    {
        if (words_.size() - 1 < least || words_.size() - 1 > most)
            fail(fmt::format("{} with {} numbers; it takes {}", words_[0], words_.size() - 1, least));
        Vector result;
        for (std::size_t i = 0; i + 1 < words_.size(); ++i) {
            const auto value = parse_real(words_[i + 1]);
            if (!value) fail(in_quotes(words_[i + 1]) + " is not a finite number");
            if (i < least) result[static_cast<int>(i)] = *value;
        }
        return result;
    }

    void read_face()
    {
        if (words_.size() < 4) fail("a face with fewer than three corners");
        polygon_.clear();
        for (std::size_t i = 1; i < words_.size(); ++i) polygon_.push_back(vertex_of(corner_of(words_[i])));
        concave_ += add_polygon(mesh_, polygon_) ? 1 : 0;
    }

    /// "7", "7/2", "7//3", "7/2/3"
    Corner corner_of(std::string_view word) const
    {
        Corner corner{-1, -1, -1};
        const std::array<std::size_t, 3> sizes{positions_.size(), uvs_.size(), normals_.size()};
        constexpr std::array<const char*, 3> kinds{"vertices", "texture coordinates", "normals"};
        std::string_view rest = word;
        for (std::size_t part = 0; part < 3; ++part) {
            const std::size_t end = std::min(rest.find('/'), rest.size());
            if (const std::string_view digits = rest.substr(0, end); !digits.empty()) {
                const auto index = parse_integer(digits);
                const auto size = static_cast<std::int64_t>(sizes[part]);
                if (!index) fail(in_quotes(word) + " is not a corner of a face");
                if (*index == 0 || *index > size || *index < -size)
                    fail(fmt::format("index {} is out of range: there are {} {} so far", *index, size, kinds[part]));
                corner[part] = *index > 0 ? *index - 1 : size + *index;
            }
            if (end == rest.size()) break;
            if (part == 2) fail(in_quotes(word) + " is not a corner of a face");
            rest.remove_prefix(end + 1);
        }
        if (corner[0] < 0) fail(in_quotes(word) + " names no vertex");
        return corner;
    }

    std::uint32_t vertex_of(const Corner& corner)
    {
        all_uvs_ = all_uvs_ && corner[1] >= 0;
        all_normals_ = all_normals_ && corner[2] >= 0;
        const auto [known, is_new] = vertices_.try_emplace(corner, static_cast<std::uint32_t>(mesh_.vertices.size()));
        if (is_new) {
            if (mesh_.vertices.size() >= std::numeric_limits<std::uint32_t>::max()) fail("more than 2^32 vertices");
            mesh_.vertices.push_back(positions_[static_cast<std::size_t>(corner[0])]);
            mesh_.uvs.push_back(corner[1] < 0 ? Vec2(0) : uvs_[static_cast<std::size_t>(corner[1])]);
            mesh_.normals.push_back(corner[2] < 0 ? Vec3(0) : normals_[static_cast<std::size_t>(corner[2])]);
        }
        return known->second;
    }

    int line_ = 0;
    std::size_t concave_ = 0;
    std::vector<std::string_view> words_;
    std::vector<std::uint32_t> polygon_;
    std::vector<Vec3> positions_, normals_;
    std::vector<Vec2> uvs_;
    std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
    Mesh mesh_;
    bool all_normals_ = true, all_uvs_ = true;
};

}  // namespace

MeshFile read_obj(std::string_view bytes) { return ObjReader().read(bytes); }

}  // namespace tyndall

// PLY, the Stanford triangle format.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "scene/mesh_files.hpp"
#include "scene/ply_header.hpp"
#include "scene/text.hpp"

namespace tyndall {

namespace {

using ply::Encoding, ply::Number;

/// Numbers one after the other.
class NumberStream {
public:
    NumberStream(std::string_view bytes, Encoding encoding) : bytes_(bytes), encoding_(encoding) {}
    std::size_t left() const { return bytes_.size(); }
    /// The least that one number takes; one digit and a blank in text (the very last needs no blank).
    std::size_t least_bytes(Number type) const { return encoding_ == Encoding::ascii ? 2 : bytes_of(type); }
    /// False if `count` rows of `row_bytes` each cannot be there.
    bool can_hold(std::uint64_t count, std::size_t row_bytes) const
    {
        const std::uint64_t available = left() + (encoding_ == Encoding::ascii ? 1 : 0);
        return row_bytes > 0 && count <= available / row_bytes;
    }
    double next(Number type) { return encoding_ == Encoding::ascii ? next_text() : next_binary(type); }

private:
    double next_text()
    {
        constexpr std::string_view blanks = " \t\r\n";
        const std::size_t first = std::min(bytes_.find_first_not_of(blanks), bytes_.size());
        const std::size_t end = std::min(bytes_.find_first_of(blanks, first), bytes_.size());
        const std::string_view word = bytes_.substr(first, end - first);
        bytes_.remove_prefix(end);
        if (word.empty()) throw MeshFault("the file ends early");
        const auto value = parse_real(word);
        if (!value) throw MeshFault(in_quotes(word) + " is not a finite number");
        return *value;
    }

    double next_binary(Number type)
    {
        const std::size_t size = bytes_of(type);
        if (left() < size) throw MeshFault("the file ends early");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::uint64_t byte = static_cast<unsigned char>(bytes_[i]);
            bits |= byte << (8 * (encoding_ == Encoding::little_endian ? i : size - 1 - i));
        }
        bytes_.remove_prefix(size);
        switch (type) {
            case Number::i8:
                return static_cast<std::int8_t>(bits);
            case Number::u8:
                return static_cast<std::uint8_t>(bits);
            case Number::i16:
                return static_cast<std::int16_t>(bits);
            case Number::u16:
                return static_cast<std::uint16_t>(bits);
            case Number::i32:
                return static_cast<std::int32_t>(bits);
            case Number::u32:
                return static_cast<std::uint32_t>(bits);
            case Number::f32:
                return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
            case Number::f64:
                return std::bit_cast<double>(bits);
        }
        return 0;
    }

    std::string_view bytes_;
    Encoding encoding_;
};

class BodyReader {
public:
    BodyReader(const ply::Header& header, std::string_view data) : header_(header), numbers_(data, header.encoding) {}

    MeshFile read()
    {
        for (const ply::Element& element : header_.elements) {
            std::size_t row_bytes = 0;
            for (const ply::Property& property : element.properties)
                row_bytes += numbers_.least_bytes(property.count.value_or(property.type));
            if (element.count > 0 && !numbers_.can_hold(element.count, row_bytes))
                throw MeshFault(fmt::format("{} rows of element {} cannot be in the {} bytes that are left", element.count,
                                            in_quotes(element.name), numbers_.left()));
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else
                for (std::uint64_t row = 0; row < element.count; ++row)
                    for (const ply::Property& property : element.properties) pass_over(property);
        }
        finish_mesh(file_, concave_);
        return std::move(file_);
    }

private:
    void pass_over(const ply::Property& property)
    {
        const std::uint64_t count = property.count ? list_size(property) : 1;
        for (std::uint64_t i = 0; i < count; ++i) numbers_.next(property.type);
    }

    std::uint64_t list_size(const ply::Property& property)
    {
        const double size = numbers_.next(*property.count);
        if (!(size >= 0) || size != std::floor(size)) throw MeshFault(fmt::format("a list of {} items", size));
        if (size > 0 && (size > 4e9 || !numbers_.can_hold(static_cast<std::uint64_t>(size), numbers_.least_bytes(property.type))))
            throw MeshFault(fmt::format("a list of {} items cannot be in the {} bytes that are left", size, numbers_.left()));
        return static_cast<std::uint64_t>(size);
    }

    static int find(const ply::Element& element, std::initializer_list<std::string_view> names)
    {
        for (std::size_t i = 0; i < element.properties.size(); ++i)
            for (const std::string_view name : names)
                if (element.properties[i].name == name && !element.properties[i].count) return static_cast<int>(i);
        return none;
    }

    void read_vertices(const ply::Element& element)
    {
        if (element.count > std::numeric_limits<std::uint32_t>::max()) throw MeshFault("more than 2^32 vertices");
        const std::array<int, 8> columns{find(element, {"x"}),      find(element, {"y"}),     find(element, {"z"}),
                                         find(element, {"nx"}),     find(element, {"ny"}),    find(element, {"nz"}),
                                         find(element, {"u", "s"}), find(element, {"v", "t"})};
        if (columns[0] == none || columns[1] == none || columns[2] == none) throw MeshFault("the vertices have no x, y and z");
        const bool normals = columns[3] != none && columns[4] != none && columns[5] != none, uvs = columns[6] != none && columns[7] != none;
        std::vector<double> row(element.properties.size());
        const auto column = [&](int i) { return row[static_cast<std::size_t>(columns[static_cast<std::size_t>(i)])]; };
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t p = 0; p < row.size(); ++p)
                if (element.properties[p].count)
                    pass_over(element.properties[p]);
                else
                    row[p] = numbers_.next(element.properties[p].type);
            file_.mesh.vertices.emplace_back(column(0), column(1), column(2));
            if (normals) file_.mesh.normals.emplace_back(column(3), column(4), column(5));
            if (uvs) file_.mesh.uvs.emplace_back(column(6), column(7));
        }
        has_vertices_ = true;
    }

    void read_faces(const ply::Element& element)
    {
        if (!has_vertices_) throw MeshFault("element \"face\" stands before element \"vertex\"");
        const auto is_indices = [](const ply::Property& p) { return p.count && (p.name == "vertex_indices" || p.name == "vertex_index"); };
        if (std::none_of(element.properties.begin(), element.properties.end(), is_indices))
            throw MeshFault("the faces have no list vertex_indices");
        for (std::uint64_t row = 0; row < element.count; ++row)
            for (const ply::Property& property : element.properties)
                if (is_indices(property))
                    read_face(row, property);
                else
                    pass_over(property);
    }

    void read_face(std::uint64_t row, const ply::Property& property)
    {
        polygon_.clear();
        const std::uint64_t corners = list_size(property);
        if (corners < 3) throw MeshFault(fmt::format("face {} has {} corners", row, corners));
        for (std::uint64_t i = 0; i < corners; ++i) {
            const double index = numbers_.next(property.type);
            if (!(index >= 0 && index < static_cast<double>(file_.mesh.vertices.size())) || index != std::floor(index))
                throw MeshFault(fmt::format("face {} names vertex {}, out of range: there are {}", row, index, file_.mesh.vertices.size()));
            polygon_.push_back(static_cast<std::uint32_t>(index));
        }
        concave_ += add_polygon(file_.mesh, polygon_) ? 1 : 0;
    }

    const ply::Header& header_;
    NumberStream numbers_;
    MeshFile file_;
    std::vector<std::uint32_t> polygon_;
    std::size_t concave_ = 0;
    bool has_vertices_ = false;
};

}  // namespace

MeshFile read_ply(std::string_view bytes)
{
    const ply::Header header = ply::read_header(bytes);
    return BodyReader(header, bytes.substr(header.size)).read();
}

}  // namespace tyndall

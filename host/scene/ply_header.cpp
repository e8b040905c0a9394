#include "scene/ply_header.hpp"

#include <fmt/format.h>

#include "scene/mesh_files.hpp"
#include "scene/text.hpp"

namespace tyndall::ply {

namespace {

std::optional<Number> number_named(std::string_view name)
{
    constexpr std::array<std::pair<std::string_view, Number>, 16> names{{
        {"char", Number::i8},
        {"uchar", Number::u8},
        {"short", Number::i16},
        {"ushort", Number::u16},
        {"int", Number::i32},
        {"uint", Number::u32},
        {"float", Number::f32},
        {"double", Number::f64},
        {"int8", Number::i8},
        {"uint8", Number::u8},
        {"int16", Number::i16},
        {"uint16", Number::u16},
        {"int32", Number::i32},
        {"uint32", Number::u32},
        {"float32", Number::f32},
        {"float64", Number::f64},
    }};
    for (const auto& [known, number] : names)
        if (name == known) return number;
    return {};
}

class HeaderReader {
public:
    explicit HeaderReader(std::string_view bytes) : bytes_(bytes) {}
    Header read()
    {
        if (next_line() != std::vector<std::string_view>{"ply"}) throw MeshFault("not a PLY file: it does not start with \"ply\"");
        bool has_format = false;
        while (true) {
            const auto words = next_line();
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
            if (words[0] == "end_header") break;
            if (words[0] == "format" && words.size() == 3)
                has_format = true, read_format(words);
            else if (words[0] == "element" && words.size() == 3)
                read_element(words);
            else if (words[0] == "property" && !header_.elements.empty())
                header_.elements.back().properties.push_back(property_of(words));
            else
                fail("not understood: " + in_quotes(words[0]));
        }
        if (!has_format) throw MeshFault("the PLY header names no format");
        header_.size = at_;
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw MeshFault(fmt::format("line {}: {}", line_, message)); }

    std::vector<std::string_view> next_line()
    {
        constexpr std::size_t longest = 4096;
        const std::size_t end = bytes_.substr(at_, longest).find('\n');
        if (end == std::string_view::npos) throw MeshFault("the PLY header does not end");
        const std::string_view line = bytes_.substr(at_, end);
        at_ += end + 1, ++line_;
        return split_list(line);
    }

    void read_format(const std::vector<std::string_view>& words)
    {
        if (words[2] != "1.0") fail("PLY version " + in_quotes(words[2]) + " is not supported");
        if (words[1] == "ascii")
            header_.encoding = Encoding::ascii;
        else if (words[1] == "binary_little_endian")
            header_.encoding = Encoding::little_endian;
        else if (words[1] == "binary_big_endian")
            header_.encoding = Encoding::big_endian;
        else
            fail("format " + in_quotes(words[1]) + " is not supported");
    }

    void read_element(const std::vector<std::string_view>& words)
    {
        const auto count = parse_integer(words[2]);
        if (!count || *count < 0) fail(in_quotes(words[2]) + " is not a count");
        for (const Element& other : header_.elements)
            if (other.name == words[1]) fail("a second element " + in_quotes(words[1]));
        header_.elements.push_back({.name = std::string(words[1]), .count = static_cast<std::uint64_t>(*count)});
    }

    Property property_of(const std::vector<std::string_view>& words) const
    {
        const bool is_list = words.size() == 5 && words[1] == "list";
        if (!is_list && words.size() != 3) fail("a property that is not understood");
        const auto type = number_named(words[is_list ? 3 : 1]);
        if (!type) fail(in_quotes(words[is_list ? 3 : 1]) + " is not a type of number");
        Property property{.name = std::string(words.back()), .type = *type};
        if (is_list) {
            property.count = number_named(words[2]);
            if (!property.count || *property.count == Number::f32 || *property.count == Number::f64)
                fail(in_quotes(words[2]) + " is not a type of count");
        }
        return property;
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    int line_ = 0;
    Header header_;
};

}  // namespace

Header read_header(std::string_view bytes) { return HeaderReader(bytes).read(); }

}  // namespace tyndall::ply

#include "scene/xml_element.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>

#include "scene/text.hpp"

namespace tyndall {

namespace {

/// Byte offset -> line and column (in characters) of one file.
class LineMap {
public:
    LineMap(const std::string& text, std::string file) : text_(text), file_(std::move(file))
    {
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') starts_.push_back(i + 1);
    }
    SourceLocation at(std::ptrdiff_t offset) const
    {
        const std::size_t byte = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
        const auto line = std::upper_bound(starts_.begin(), starts_.end(), byte) - 1;
        const auto first_byte_of_character = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
        // Places are asked for in the order of the text: counting goes on where it stopped, or one long line would cost its length every
        // time.
        if (*line > last_byte_ || byte < last_byte_) last_byte_ = *line, last_column_ = 1;
        last_column_ += static_cast<int>(std::count_if(text_.begin() + static_cast<std::ptrdiff_t>(last_byte_),
                                                       text_.begin() + static_cast<std::ptrdiff_t>(byte), first_byte_of_character));
        last_byte_ = byte;
        return {.file = file_, .line = static_cast<int>(line - starts_.begin()) + 1, .column = last_column_};
    }

private:
    const std::string& text_;
    std::string file_;
    std::vector<std::size_t> starts_{0};
    mutable std::size_t last_byte_ = 0;
    mutable int last_column_ = 1;
};

/// pugixml points behind the '<' of a tag; a message points at it.
SourceLocation place_of(const LineMap& lines, const pugi::xml_node& node)
{
    return lines.at(node.offset_debug() - (node.type() == pugi::node_element));
}

void check_limits(const std::string& text, const LineMap& lines)
{
    using namespace xml_limits;
    if (text.size() > bytes) refuse(lines.at(0), fmt::format("a scene file of {} bytes; the limit is {}", text.size(), bytes));
    if (const auto zero = text.find('\0'); zero != std::string::npos)
        refuse(lines.at(static_cast<std::ptrdiff_t>(zero)), "a zero byte; scene files are UTF-8 text");
    if (static_cast<std::size_t>(std::count(text.begin(), text.end(), '<')) > tags)
        refuse(lines.at(0), fmt::format("more than {} tags; put geometry into OBJ or PLY files", tags));
}

XmlElement convert(const pugi::xml_node& node, const LineMap& lines, int depth)
{
    XmlElement element{.tag = node.name(), .where = place_of(lines, node)};
    if (depth > xml_limits::depth) refuse(element.where, fmt::format("elements are nested deeper than {}", xml_limits::depth));
    for (const pugi::xml_attribute& attribute : node.attributes()) {
        if (element.attributes.size() == xml_limits::attributes)
            refuse(element.where, fmt::format("an element with more than {} attributes", xml_limits::attributes));
        if (element.find(attribute.name()))
            refuse(element.where, fmt::format("<{}> has the attribute {} twice", printable(element.tag), in_quotes(attribute.name())));
        element.attributes.push_back({attribute.name(), attribute.value()});
        if (element.attributes.back().value.size() > xml_limits::attribute_bytes)
            refuse(element.where, fmt::format("an attribute longer than {} bytes", xml_limits::attribute_bytes));
    }
    for (const pugi::xml_node& child : node.children()) {
        if (child.type() == pugi::node_doctype) refuse(place_of(lines, child), "a DOCTYPE is not accepted");
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
            refuse(place_of(lines, child),
                   fmt::format("text inside <{}>: {}; values are written as attributes", printable(element.tag), in_quotes(child.value())));
        if (child.type() == pugi::node_element) element.children.push_back(convert(child, lines, depth + 1));
    }
    return element;
}

}  // namespace

const std::string* XmlElement::find(std::string_view attribute) const
{
    const auto found = std::find_if(attributes.begin(), attributes.end(), [&](const XmlAttribute& a) { return a.name == attribute; });
    return found == attributes.end() ? nullptr : &found->value;
}

std::string XmlElement::value_of(std::string_view attribute) const
{
    const std::string* value = find(attribute);
    return value ? *value : "";
}

XmlElement parse_xml(const std::string& given, const std::string& file)
{
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    const std::string text = given.starts_with(byte_order_mark) ? given.substr(byte_order_mark.size()) : given;
    const LineMap lines(text, file);
    check_limits(text, lines);
    pugi::xml_document document;
    constexpr unsigned options = pugi::parse_default | pugi::parse_doctype;
    const auto result = document.load_buffer(text.data(), text.size(), options, pugi::encoding_utf8);
    if (!result && result.status != pugi::status_no_document_element) {
        std::string what = result.description();
        if (!what.empty()) what[0] = static_cast<char>(what[0] | 0x20);  // pugixml starts with a capital letter
        refuse(lines.at(result.offset), "not well-formed XML: " + what);
    }
    const pugi::xml_node* root = nullptr;
    pugi::xml_node found;
    for (const pugi::xml_node& node : document.children()) {
        if (node.type() == pugi::node_doctype) refuse(place_of(lines, node), "a DOCTYPE is not accepted");
        if (node.type() != pugi::node_element) continue;
        if (root) refuse(place_of(lines, node), fmt::format("a second root element <{}>", printable(node.name())));
        found = node, root = &found;
    }
    if (!root) refuse(lines.at(0), "there is no element; a scene starts with <scene version=\"3.0.0\">");
    return convert(*root, lines, 1);
}

}  // namespace tyndall

#pragma once
/// An XML file as plain data with a place for every element. pugixml stays behind xml_element.cpp.
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall {

struct XmlAttribute {
    std::string name, value;
};

struct XmlElement {
    std::string tag;
    std::vector<XmlAttribute> attributes;
    std::vector<XmlElement> children;
    SourceLocation where;

    /// Null if there is no such attribute.
    const std::string* find(std::string_view attribute) const;
    /// "" if there is no such attribute.
    std::string value_of(std::string_view attribute) const;
};

/// Limits that keep a hostile file from exhausting memory, stack or patience.
namespace xml_limits {
inline constexpr std::size_t bytes = 32u << 20;           ///< of one file
inline constexpr std::size_t tags = 1'000'000;            ///< opening and closing tags of one file
inline constexpr int depth = 64;                          ///< of nesting
inline constexpr std::size_t attribute_bytes = 1u << 16;  ///< of one attribute, after substitution
inline constexpr std::size_t elements = 500'000;          ///< of a scene with all its includes
inline constexpr std::size_t attributes = 32;             ///< of one element
inline constexpr std::size_t included_bytes = 256u << 20;
inline constexpr int include_depth = 16;
inline constexpr int includes = 1000;
}  // namespace xml_limits

/// The root element of the text of one file. Throws SceneError at the line and column of what is wrong: not well formed, a DOCTYPE, text
/// between elements, an attribute twice, beyond the limits.
XmlElement parse_xml(const std::string& text, const std::string& file);

}  // namespace tyndall

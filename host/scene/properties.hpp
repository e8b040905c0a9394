#pragma once
/// The parameters and nested objects of one element of a scene file. Whoever reads the element asks for each by name and type; `finish`
/// refuses what nobody asked for, with the nearest name that was asked for.
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "scene/scene_document.hpp"

namespace tyndall {

/// What numbers a parameter may take.
struct Range {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    bool open = false;  ///< the ends themselves are excluded
    static Range any() { return {}; }
    static Range not_negative() { return {.low = 0}; }
    static Range positive() { return {.low = 0, .open = true}; }
    static Range between(double low, double high) { return {low, high, false}; }
    static Range strictly_between(double low, double high) { return {low, high, true}; }
    bool contains(double value) const { return open ? value > low && value < high : value >= low && value <= high; }
    std::string words() const;  ///< "must lie strictly between -1 and 1"
};

/// A nested object, written in place or named by a <ref>.
struct Nested {
    const XmlElement* object;   ///< the object itself
    const XmlElement* mention;  ///< the element that stands in the parent: the object or the ref
    std::string role;           ///< its name attribute: "interior"
};

class Properties {
public:
    /// `title`: how messages call the element; by default its tag with its id or type: medium "juice".
    Properties(const XmlElement& element, const SceneDocument& document, std::string title = "");

    const std::string& type() const { return type_; }
    const std::string& title() const { return title_; }
    const SourceLocation& where() const { return element_.where; }
    const SceneDocument& document() const { return document_; }
    std::string id_or_type() const;

    bool has(const std::string& name);
    double real(const std::string& name, double fallback, const Range& range = Range::any());
    int integer(const std::string& name, int fallback, int low, int high);
    bool boolean(const std::string& name, bool fallback);
    std::string text(const std::string& name, const std::string& fallback);
    /// One of `choices`.
    std::string choice(const std::string& name, const std::string& fallback, const std::vector<std::string>& choices);
    /// <rgb>, <float> or a <spectrum> of one value: grey.
    Rgb colour(const std::string& name, const Rgb& fallback, const Range& range);
    /// The same without <spectrum>: in RGB mode a uniform spectrum of light is not white.
    Rgb light_colour(const std::string& name, const Rgb& fallback);
    /// <point> or <vector>.
    Vec3 vector(const std::string& name, const Vec3& fallback);
    /// <transform>; the identity if absent.
    Mat4 transform(const std::string& name);
    /// A <string> or a <float> is there: the tag that the parameter was written with, "" if absent.
    std::string written_as(const std::string& name);
    /// Where the parameter stands; where the element stands if absent.
    SourceLocation where_is(const std::string& name) const;

    /// All nested objects with this tag.
    std::vector<Nested> nested(const std::string& tag);
    /// At most one nested object with this tag; null if there is none.
    const XmlElement* single(const std::string& tag);
    /// The nested object with this tag that stands in for the parameter `name` (name="reflectance"); null if there is none. Refuses a second one, and one beside a value.
    const XmlElement* nested_as(const std::string& tag, const std::string& name);

    /// Takes what is left of the parameters (an integrator's, a sampler's: they are not ours).
    void ignore_parameters();
    /// Refuses what is left.
    void finish();

    /// Throws SceneError at `name`'s place: `title: message`.
    [[noreturn]] void refuse_parameter(const std::string& name, const std::string& message) const;
    /// Throws SceneError: this tag has no such type.
    [[noreturn]] void refuse_type(const std::vector<std::string>& supported) const;

private:
    struct Parameter {
        std::string name;
        const XmlElement* element;
        bool used = false;
    };
    struct Child {
        Nested nested;
        bool used = false;
    };
    void take(const XmlElement& child);
    Parameter* use(const std::string& name, const std::vector<std::string>& tags);
    Rgb colour_of(const Parameter& parameter, bool is_light) const;

    const XmlElement& element_;
    const SceneDocument& document_;
    std::string type_, title_;
    std::vector<Parameter> parameters_;
    std::vector<Child> children_;
    std::set<std::string> asked_, asked_tags_, asked_roles_;
};

/// Refuses attributes that the element does not take, naming the nearest that it does.
void require_known_attributes(const XmlElement& element, const std::vector<std::string>& known);

}  // namespace tyndall

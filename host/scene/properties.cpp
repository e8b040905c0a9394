#include "scene/properties.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/text.hpp"
#include "scene/transforms.hpp"

namespace tyndall {

namespace {

const std::vector<std::string> parameter_tags{"string", "float", "integer", "boolean", "point", "vector", "rgb", "spectrum", "transform"};
const std::vector<std::string> object_tags{"integrator", "sampler", "sensor", "film",    "rfilter", "medium",
                                           "phase",      "shape",   "bsdf",   "emitter", "texture", "volume"};

constexpr std::size_t most_parameters = 256;  ///< of one element

bool among(const std::string& word, const std::vector<std::string>& words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::string tags_in_words(const std::vector<std::string>& tags)
{
    std::string words;
    for (std::size_t i = 0; i < tags.size(); ++i)
        words += fmt::format("{}<{}>", i == 0 ? "" : i + 1 == tags.size() ? " or " : ", ", tags[i]);
    return words;
}

}  // namespace

void require_known_attributes(const XmlElement& element, const std::vector<std::string>& known)
{
    for (const XmlAttribute& attribute : element.attributes)
        if (!among(attribute.name, known))
            refuse(element.where, fmt::format("<{}> has no attribute {}{}; it takes: {}", printable(element.tag), in_quotes(attribute.name),
                                              suggestion(attribute.name, known), join(known)));
}

std::string Range::words() const
{
    const bool low_end = low > -std::numeric_limits<double>::infinity(), high_end = high < std::numeric_limits<double>::infinity();
    if (low_end && high_end)
        return open ? fmt::format("must lie strictly between {} and {}", low, high) : fmt::format("must lie between {} and {}", low, high);
    if (low_end && low == 0) return open ? "must be positive" : "must not be negative";
    if (low_end) return fmt::format("must be {} {}", open ? "greater than" : "at least", low);
    return high_end ? fmt::format("must be at most {}", high) : "may be any number";
}

Properties::Properties(const XmlElement& element, const SceneDocument& document, std::string title)
    : element_(element), document_(document), type_(element.value_of("type")), title_(std::move(title))
{
    if (title_.empty()) title_ = printable(element.tag) + (id_or_type().empty() ? "" : " " + in_quotes(id_or_type()));
    if (element.tag != "scene") {
        require_known_attributes(element, {"type", "id", "name"});
        if (type_.empty()) refuse(element.where, fmt::format("<{}> needs the attribute \"type\"", printable(element.tag)));
    }
    for (const XmlElement& child : element.children) take(child);
}

std::string Properties::id_or_type() const
{
    const std::string* id = element_.find("id");
    return id ? *id : type_;
}

void Properties::take(const XmlElement& child)
{
    const bool typed_spectrum = child.tag == "spectrum" && child.find("type");
    if (child.tag == "alias") return;
    if (child.tag == "ref") {
        require_known_attributes(child, {"id", "name"});
        children_.push_back({.nested = {.object = &document_.resolve(child), .mention = &child, .role = child.value_of("name")}});
    } else if (among(child.tag, parameter_tags) && !typed_spectrum) {
        const std::string name = child.value_of("name");
        if (name.empty()) refuse(child.where, fmt::format("{}: <{}> needs the attribute \"name\"", title_, child.tag));
        if (parameters_.size() == most_parameters) refuse(child.where, fmt::format("{}: more than {} parameters", title_, most_parameters));
        for (const Parameter& other : parameters_)
            if (other.name == name)
                refuse(child.where,
                       fmt::format("{}: {} is given twice, first at {}", title_, printable(name), to_string(other.element->where)));
        parameters_.push_back({.name = name, .element = &child});
    } else if (among(child.tag, object_tags) || typed_spectrum) {
        children_.push_back({.nested = {.object = &child, .mention = &child, .role = child.value_of("name")}});
    } else {
        std::vector<std::string> known = parameter_tags;
        known.insert(known.end(), object_tags.begin(), object_tags.end());
        known.insert(known.end(), {"ref", "default", "include", "path", "alias"});
        refuse(child.where, fmt::format("{}: unknown element <{}>{}", title_, printable(child.tag), suggestion(child.tag, known)));
    }
}

Properties::Parameter* Properties::use(const std::string& name, const std::vector<std::string>& tags)
{
    asked_.insert(name);
    for (Child& child : children_)
        if (child.nested.role == name)
            refuse(child.nested.mention->where,
                   fmt::format("{}: {} as <{} type={}> is not supported; write it as {}", title_, printable(name),
                               printable(child.nested.object->tag), in_quotes(child.nested.object->value_of("type")), tags_in_words(tags)));
    for (Parameter& parameter : parameters_) {
        if (parameter.name != name) continue;
        if (!among(parameter.element->tag, tags))
            refuse(parameter.element->where,
                   fmt::format("{}: {} is written as <{}>; it must be {}", title_, name, parameter.element->tag, tags_in_words(tags)));
        parameter.used = true;
        return &parameter;
    }
    return nullptr;
}

bool Properties::has(const std::string& name)
{
    asked_.insert(name);
    return std::any_of(parameters_.begin(), parameters_.end(), [&](const Parameter& p) { return p.name == name; });
}

SourceLocation Properties::where_is(const std::string& name) const
{
    for (const Parameter& parameter : parameters_)
        if (parameter.name == name) return parameter.element->where;
    return element_.where;
}

std::string Properties::written_as(const std::string& name)
{
    asked_.insert(name);
    for (const Parameter& parameter : parameters_)
        if (parameter.name == name) return parameter.element->tag;
    return "";
}

std::vector<Nested> Properties::nested(const std::string& tag)
{
    asked_tags_.insert(tag);
    std::vector<Nested> found;
    for (Child& child : children_)
        if (child.nested.object->tag == tag) child.used = true, found.push_back(child.nested);
    return found;
}

const XmlElement* Properties::single(const std::string& tag)
{
    const std::vector<Nested> found = nested(tag);
    if (found.size() > 1) refuse(found[1].mention->where, fmt::format("{}: a second {}; it takes one", title_, tag));
    return found.empty() ? nullptr : found[0].object;
}

const XmlElement* Properties::nested_as(const std::string& tag, const std::string& name)
{
    asked_roles_.insert(name);
    const XmlElement* found = nullptr;
    for (Child& child : children_) {
        if (child.nested.object->tag != tag || child.nested.role != name) continue;
        if (found || has(name)) refuse(child.nested.mention->where, fmt::format("{}: {} is given twice", title_, printable(name)));
        child.used = true, found = child.nested.object;
    }
    return found;
}

void Properties::ignore_parameters()
{
    for (Parameter& parameter : parameters_) parameter.used = true;
}

void Properties::finish()
{
    const std::vector<std::string> known(asked_.begin(), asked_.end()), tags(asked_tags_.begin(), asked_tags_.end());
    for (const Parameter& parameter : parameters_)
        if (!parameter.used)
            refuse(parameter.element->where,
                   fmt::format("{}: unknown parameter {}{}{}", title_, in_quotes(parameter.name), suggestion(parameter.name, known),
                               known.empty() ? "; it takes none" : "; it takes: " + join(known)));
    const std::vector<std::string> roles(asked_roles_.begin(), asked_roles_.end());
    for (const Child& child : children_)
        if (!child.used && !roles.empty() && child.nested.object->tag == "texture")
            refuse(child.nested.mention->where, fmt::format("{}: a <texture> needs the name of what it colours{}; it may be: {}", title_, suggestion(child.nested.role, roles), join(roles)));
    for (const Child& child : children_)
        if (!child.used)
            refuse(child.nested.mention->where,
                   fmt::format("{}: <{} type={}> is not supported here{}", title_, printable(child.nested.object->tag),
                               in_quotes(child.nested.object->value_of("type")),
                               tags.empty() ? "; nothing can be nested in it" : "; it takes: " + join(tags)));
}

void Properties::refuse_parameter(const std::string& name, const std::string& message) const
{
    refuse(where_is(name), fmt::format("{}: {}", title_, message));
}

void Properties::refuse_type(const std::vector<std::string>& supported) const
{
    refuse(element_.where, fmt::format("{} type {} is not supported{}; supported: {}", printable(element_.tag), in_quotes(type_),
                                       suggestion(type_, supported), join(supported)));
}

}  // namespace tyndall

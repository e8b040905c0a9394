#include "scene/scene_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/text.hpp"

namespace tyndall {

namespace {

void require_attributes(const XmlElement& element, const std::vector<std::string>& names)
{
    for (const XmlAttribute& attribute : element.attributes)
        if (std::find(names.begin(), names.end(), attribute.name) == names.end())
            refuse(element.where, fmt::format("<{}> has no attribute {}{}; it takes: {}", printable(element.tag), in_quotes(attribute.name),
                                              suggestion(attribute.name, names), join(names)));
    for (const std::string& name : names)
        if (element.value_of(name).empty())
            refuse(element.where, fmt::format("<{}> needs the attribute {}", printable(element.tag), in_quotes(name)));
}

void check_version(const XmlElement& scene)
{
    const std::string* version = scene.find("version");
    if (!version) refuse(scene.where, "<scene> needs the attribute \"version\", for example version=\"3.0.0\"");
    std::string numbers = *version;
    std::replace(numbers.begin(), numbers.end(), '.', ' ');
    const auto pieces = split_list(numbers);
    const auto valid = [](std::string_view piece) { return parse_integer(piece).value_or(-1) >= 0; };
    if (pieces.empty() || pieces.size() > 3 || !std::all_of(pieces.begin(), pieces.end(), valid))
        refuse(scene.where, "version " + in_quotes(*version) + " is not of the form 3.0.0");
    if (*parse_integer(pieces[0]) < 2)
        refuse(scene.where, "version " + in_quotes(*version) + " is too old; scenes of version 2.0.0 and later are read");
}

constexpr std::size_t longest_name = 100;
bool belongs_to_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

/// Puts a document in place, in document order.
class Assembler {
public:
    Assembler(SceneFiles& files, const std::map<std::string, std::string>& definitions, const std::string& main_file)
        : files_(files), definitions_(definitions), main_file_(main_file), parameters_(definitions)
    {
    }

    XmlElement assemble(XmlElement root)
    {
        substitute(root);
        if (root.tag != "scene")
            refuse(root.where, fmt::format("the root element is <{}>; a scene starts with <scene version=\"3.0.0\">", printable(root.tag)));
        check_version(root);
        XmlElement result{.tag = root.tag, .attributes = root.attributes, .where = root.where};
        take_children(root, result, 1);
        check_definitions(root.where.file);
        return result;
    }

private:
    void take_children(XmlElement& from, XmlElement& to, int depth)
    {
        if (depth > xml_limits::depth) refuse(from.where, fmt::format("elements are nested deeper than {}", xml_limits::depth));
        for (XmlElement& child : from.children) {
            substitute(child);
            if (child.tag == "default") {
                take_default(child);
            } else if (child.tag == "path") {
                if (depth != 1) refuse(child.where, "<path> stands at the top of the scene only");
                require_attributes(child, {"value"});
                files_.add_search_folder(child.value_of("value"), child.where);
            } else if (child.tag == "include") {
                include(child, to, depth);
            } else {
                take_element(child, to, depth);
            }
        }
    }

    void take_element(XmlElement& child, XmlElement& to, int depth)
    {
        if (++elements_ > xml_limits::elements)
            refuse(child.where, fmt::format("more than {} elements; put geometry into OBJ or PLY files", xml_limits::elements));
        XmlElement taken{.tag = child.tag, .attributes = std::move(child.attributes), .where = child.where};
        take_children(child, taken, depth + 1);
        to.children.push_back(std::move(taken));
    }

    void take_default(const XmlElement& element)
    {
        require_attributes(element, {"name", "value"});
        const std::string name = element.value_of("name");
        if (name.size() > longest_name || !std::all_of(name.begin(), name.end(), belongs_to_name))
            refuse(element.where, "<default> name " + in_quotes(name) + " must be of letters, digits and _, at most 100");
        used_.insert(name);
        parameters_.emplace(name, element.value_of("value"));  // a definition or an earlier default wins
    }

    void include(const XmlElement& element, XmlElement& to, int depth)
    {
        require_attributes(element, {"filename"});
        if (++includes_ > xml_limits::includes) refuse(element.where, fmt::format("more than {} includes", xml_limits::includes));
        if (open_.size() >= xml_limits::include_depth)
            refuse(element.where, fmt::format("includes are nested deeper than {}", xml_limits::include_depth));
        const std::string name = element.value_of("filename");
        const SceneFiles::Content content = files_.read(name, element.where, xml_limits::bytes);
        included_bytes_ += content.bytes.size();
        if (included_bytes_ > xml_limits::included_bytes)
            refuse(element.where, fmt::format("more than {} bytes of includes", xml_limits::included_bytes));
        const std::string path = content.path.string();
        std::error_code fault;
        if (std::find(open_.begin(), open_.end(), path) != open_.end() || std::filesystem::equivalent(path, main_file_, fault))
            refuse(element.where, in_quotes(name) + " includes itself");
        open_.push_back(path);
        XmlElement root = parse_xml(content.bytes, path);
        substitute(root);
        if (root.tag == "scene") {
            if (root.find("version")) check_version(root);
            take_children(root, to, depth);
        } else {
            take_element(root, to, depth);
        }
        open_.pop_back();
    }

    void substitute(XmlElement& element)
    {
        for (XmlAttribute& attribute : element.attributes)
            if (attribute.value.find('$') != std::string::npos) attribute.value = substituted(attribute.value, element.where);
    }

    std::string substituted(const std::string& text, const SourceLocation& where)
    {
        std::string result;
        for (std::size_t at = 0; at < text.size();) {
            if (text[at] != '$') {
                result += text[at++];
                continue;
            }
            const std::string name = parameter_at(text, at + 1, where);
            result += parameters_.at(name);
            used_.insert(name);
            at += 1 + name.size();
            if (result.size() > xml_limits::attribute_bytes)
                refuse(where, fmt::format("an attribute grows beyond {} bytes when its $names are replaced", xml_limits::attribute_bytes));
        }
        return result;
    }

    /// The longest parameter whose name stands at `at`.
    std::string parameter_at(const std::string& text, std::size_t at, const SourceLocation& where) const
    {
        std::size_t end = at;
        while (end < text.size() && end - at < longest_name && belongs_to_name(text[end])) ++end;
        for (std::size_t size = end - at; size > 0; --size)
            if (parameters_.contains(text.substr(at, size))) return text.substr(at, size);
        std::vector<std::string> known;
        for (const auto& [name, value] : parameters_) known.push_back(name);
        const std::string wanted = text.substr(at, end - at);
        refuse(where, fmt::format("${0} is not defined{1}; give it a <default>, or define it with -D {0}=value", printable(wanted),
                                  suggestion(wanted, known)));
    }

    void check_definitions(const std::string& file) const
    {
        for (const auto& [name, value] : definitions_)
            if (!used_.contains(name))
                throw SceneError(fmt::format("{}: nothing uses the definition {}{}", printable(file), in_quotes(name),
                                             suggestion(name, std::vector<std::string>(used_.begin(), used_.end()))));
    }

    SceneFiles& files_;
    const std::map<std::string, std::string>& definitions_;
    std::string main_file_;
    std::map<std::string, std::string> parameters_;
    std::set<std::string> used_;
    std::vector<std::string> open_;
    std::size_t elements_ = 0;
    std::size_t included_bytes_ = 0;
    int includes_ = 0;
};

}  // namespace

SceneDocument::SceneDocument(XmlElement root, SceneFiles& files, const std::map<std::string, std::string>& definitions)
{
    const std::string file = root.where.file;
    root_ = Assembler(files, definitions, file).assemble(std::move(root));
    collect_ids(root_);
    for (const auto& [name, alias] : aliases_) {
        const auto& [id, where] = alias;
        if (objects_.contains(name)) refuse(where, "the id " + in_quotes(name) + " is taken, at " + to_string(objects_.at(name)->where));
    }
}

void SceneDocument::collect_ids(const XmlElement& element)
{
    for (const XmlElement& child : element.children) {
        if (child.tag == "alias") {
            require_attributes(child, {"id", "as"});
            const auto [at, is_new] = aliases_.try_emplace(child.value_of("as"), child.value_of("id"), child.where);
            if (!is_new) refuse(child.where, "the alias " + in_quotes(at->first) + " is taken, at " + to_string(at->second.second));
        } else if (const std::string* id = child.find("id"); id && child.tag != "ref") {
            const auto [at, is_new] = objects_.try_emplace(*id, &child);
            if (!is_new) refuse(child.where, "the id " + in_quotes(*id) + " is taken, at " + to_string(at->second->where));
        }
        collect_ids(child);
    }
}

const XmlElement& SceneDocument::resolve(const XmlElement& ref) const
{
    std::string id = ref.value_of("id");
    if (id.empty()) refuse(ref.where, "<ref> needs the attribute \"id\"");
    // Every step consumes one alias; more steps than aliases means that they go round.
    for (std::size_t step = 0; step <= aliases_.size(); ++step) {
        if (const auto object = objects_.find(id); object != objects_.end()) return *object->second;
        const auto alias = aliases_.find(id);
        if (alias == aliases_.end()) break;
        id = alias->second.first;
    }
    std::vector<std::string> known;
    for (const auto& [name, element] : objects_) known.push_back(name);
    refuse(ref.where, "nothing has the id " + in_quotes(id) + suggestion(id, known));
}

}  // namespace tyndall

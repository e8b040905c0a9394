#pragma once
/// A scene file with everything put in place: includes spliced in, $names replaced, <default>, <path> and <alias> done, ids found.
/// What is left are objects and their parameters.
#include <map>
#include <string>

#include "scene/scene_files.hpp"
#include "scene/xml_element.hpp"

namespace tyndall {

class SceneDocument {
public:
    /// Throws SceneError at whatever is wrong, a definition that nothing uses included.
    SceneDocument(XmlElement root, SceneFiles& files, const std::map<std::string, std::string>& definitions);
    SceneDocument(const SceneDocument&) = delete;

    const XmlElement& root() const { return root_; }

    /// The object that a <ref> names, wherever in the scene it stands. Throws SceneError at the ref, with the nearest known id.
    const XmlElement& resolve(const XmlElement& ref) const;

private:
    void collect_ids(const XmlElement& element);

    XmlElement root_;
    std::map<std::string, const XmlElement*> objects_;
    std::map<std::string, std::pair<std::string, SourceLocation>> aliases_;  ///< new name -> id, place of the <alias>
};

}  // namespace tyndall

#include <algorithm>

#include "path_tracing/path_tracing.hpp"
#include "transport/bsdf.hpp"

namespace tyndall {
namespace {

/// "point", "spot", "directional"; empty for lights that a ray can meet.
std::string kind_without_size(const Emitter& emitter)
{
    switch (emitter.type) {
        case Emitter::Type::point:
            return "point";
        case Emitter::Type::spot:
            return "spot";
        case Emitter::Type::directional:
            return "directional";
        default:
            return {};
    }
}

const Shape* first_specular(const Scene& scene)
{
    const auto found =
        std::find_if(scene.shapes.begin(), scene.shapes.end(), [&](const Shape& s) { return specular(scene.bsdfs[s.bsdf]); });
    return found == scene.shapes.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> uncarried_light(const Scene& scene)
{
    std::vector<std::string> sentences;
    for (const Emitter& emitter : scene.emitters) {
        const Shape* mirror = first_specular(scene);
        const std::string kind = kind_without_size(emitter);
        if (kind.empty() || !mirror) continue;
        sentences.push_back(to_string(emitter.where) + ": " + kind + " light \"" + emitter.name +
                            "\" has no size: path tracing does not find what it sends over the smooth glass, mirror or plastic \"" + mirror->name +
                            "\" (" + to_string(mirror->where) + ") before it is scattered; use a small area light to see that light");
    }
    return sentences;
}

}  // namespace tyndall

#include "scene/scene_effects.hpp"

#include <fmt/format.h>

#include "scene/scene_warnings.hpp"
#include "scene/text.hpp"
#include "scene/thin_media.hpp"

namespace tyndall {
namespace {

using Found = std::optional<Cause>;

bool any_above(const Rgb& value, double low) { return glm::any(glm::greaterThan(value, Rgb(low))); }

/// The first element of `list` for which `holds`, said by `sentence`.
template <class Element, class Holds, class Sentence>
Found first_of(const std::vector<Element>& list, Holds&& holds, Sentence&& sentence)
{
    for (const Element& element : list)
        if (holds(element)) return Cause{sentence(element), element.where};
    return std::nullopt;
}

std::string named(const char* kind, const std::string& name, const std::string& rest) { return fmt::format("{} {}{}", kind, in_quotes(name), rest); }

Found lights(const Scene& scene)
{
    return first_of(scene.emitters, [](const Emitter& e) { return any_above(e.value, 0); }, [](const Emitter& e) { return named("emitter", e.name, ""); });
}

Found media(const Scene& scene)
{
    return first_of(scene.media, [](const Medium& m) { return any_above(m.sigma_t, 0); }, [](const Medium& m) { return named("medium", m.name, ""); });
}

Found scattering_media(const Scene& scene)
{
    return first_of(scene.media, [](const Medium& m) { return any_above(m.sigma_s(), 0); },
                    [](const Medium& m) { return named("medium", m.name, ": albedo above 0"); });
}

Found only_absorbing_media(const Scene& scene)
{
    return first_of(scene.media, [](const Medium& m) { return any_above(m.sigma_t, 0) && !any_above(m.sigma_s(), 0); },
                    [](const Medium& m) { return named("medium", m.name, ": albedo 0"); });
}

Found unbounded_media(const Scene& scene)
{
    const int medium = outermost_medium(scene);
    if (medium == vacuum) return std::nullopt;
    const Medium& m = scene.media[static_cast<std::size_t>(medium)];
    return Cause{named("medium", m.name, ": no boundary ends it, so it fills all space"), m.where};
}

/// Media so thin that what they scatter twice in a row is below a hundredth of what they scatter.
Found thin_media(const Scene& scene)
{
    constexpr double thin = .01;
    const ScatteredAgain again = scattered_again(scene);
    if (again.where.line == 0 && again.why.empty()) return std::nullopt;
    if (again.share > thin) return std::nullopt;
    return Cause{fmt::format("{}, so at most {:.2g} % of what media scatter is scattered there again", again.why, 100 * again.share), again.where};
}

Found convex_containers(const Scene& scene)
{
    const ContainerSearch search = find_containers(scene);
    if (search.containers.empty()) return std::nullopt;
    const Shape& shape = scene.shapes[static_cast<std::size_t>(search.containers.front().shape)];
    return Cause{named("shape", shape.name, fmt::format(": closed, convex, {} sides", search.containers.front().planes.size())), shape.where};
}

Found lights_in_media(const Scene& scene)
{
    return first_of(scene.emitters, [](const Emitter& e) { return e.medium != vacuum; },
                    [&](const Emitter& e) { return named("emitter", e.name, " stands in medium " + in_quotes(scene.media[static_cast<std::size_t>(e.medium)].name)); });
}

/// The first shape with a Bsdf, on its front or back, for which `holds`.
template <class Holds>
Found first_surface(const Scene& scene, Holds&& holds)
{
    for (const Shape& shape : scene.shapes) {
        const Bsdf& front = scene.bsdfs[static_cast<std::size_t>(shape.bsdf)];
        const Bsdf& back = front.back == none ? front : scene.bsdfs[static_cast<std::size_t>(front.back)];
        if (holds(front) || holds(back)) return Cause{named("shape", shape.name, ""), shape.where};
    }
    return std::nullopt;
}

/// Scatters over directions, but not the same to all of them, or to both sides.
bool glossy(const Bsdf& b)
{
    switch (b.type) {
        case Bsdf::Type::rough_dielectric: return any_above(b.reflectance, 0) || any_above(b.specular_transmittance, 0);
        case Bsdf::Type::rough_conductor: return any_above(b.reflectance, 0);
        case Bsdf::Type::plastic: return any_above(b.diffuse, 0);
        case Bsdf::Type::rough_plastic: return any_above(b.diffuse, 0) || any_above(b.reflectance, 0);
        default: return false;
    }
}

bool smooth(const Bsdf& b)
{
    return b.type == Bsdf::Type::dielectric || b.type == Bsdf::Type::thin_dielectric || b.type == Bsdf::Type::conductor || b.type == Bsdf::Type::plastic;
}

bool reflects_diffusely(const Bsdf& b) { return b.type == Bsdf::Type::diffuse && any_above(b.reflectance, 0); }

Found receiving_surfaces(const Scene& scene)
{
    return first_surface(scene, [](const Bsdf& b) { return reflects_diffusely(b) || glossy(b); });
}

Found glossy_surfaces(const Scene& scene) { return first_surface(scene, glossy); }

/// Does some triangle of a flat-shaded mesh have part of a region in front of it? (All other shapes: yes.)
bool faces(const Shape& shape, const std::vector<Bounds>& regions)
{
    if (shape.type != Shape::Type::mesh || !shape.mesh.normals.empty()) return true;
    constexpr double touching = 1e-9;  // render space has radius 1: what only touches the plane of a triangle lights it edge-on
    for (const glm::uvec3& t : shape.mesh.triangles) {
        const Vec3 a = shape.mesh.vertices[t.x], cross = glm::cross(shape.mesh.vertices[t.y] - a, shape.mesh.vertices[t.z] - a);
        const Vec3 normal = (shape.flip_normals ? -1. : 1.) * cross;
        for (const Bounds& box : regions) {
            const Vec3 furthest = glm::mix(box.low, box.high, Vec3(glm::greaterThan(normal, Vec3(0))));
            if (glm::dot(normal, furthest - a) > touching * glm::length(normal)) return true;
        }
    }
    return false;
}

/// Surfaces on whose reflecting side a scattering medium lies.
Found surfaces_in_reach(const Scene& scene)
{
    if (!scattering_media(scene)) return std::nullopt;
    const auto regions = scattering_regions(scene);
    for (const Shape& shape : scene.shapes) {
        const Bsdf& front = scene.bsdfs[static_cast<std::size_t>(shape.bsdf)];
        const bool one_sided = !front.two_sided && front.back == none;
        const bool reflects = reflects_diffusely(front) || (front.back != none && reflects_diffusely(scene.bsdfs[static_cast<std::size_t>(front.back)]));
        if (reflects && (!regions || !one_sided || faces(shape, *regions))) return Cause{named("shape", shape.name, " may be lit by a medium"), shape.where};
    }
    return std::nullopt;
}

Found specular_surfaces(const Scene& scene)
{
    return first_surface(scene, smooth);
}

}  // namespace

const std::vector<SceneFact>& scene_facts()
{
    static const std::vector<SceneFact> facts{
        {{"LIGHTS", 0, "something gives light", "every layer: the image is black"}, lights},
        {{"MEDIA", 0, "a medium has extinction", "transmittance, virtual lights, eye segments, kernels, the OpenCL device"}, media},
        {{"SCATTERING_MEDIA", 0, "a medium scatters", "virtual lights, eye segments, kernels; media only dim what is behind them"}, scattering_media},
        {{"ONLY_ABSORBING_MEDIA", 0, "a medium absorbs and does not scatter", ""}, only_absorbing_media},
        {{"UNBOUNDED_MEDIA", 0, "a medium has no boundary", ""}, unbounded_media},
        {{"OPTICALLY_THIN", 0, "media scatter less than 1 % of their light twice in a row", ""}, thin_media},
        {{"CONVEX_CONTAINERS", 0, "media fill disjoint convex polyhedra", ""}, convex_containers},
        {{"LIGHTS_IN_MEDIA", 0, "a light stands inside a medium", ""}, lights_in_media},
        {{"RECEIVING_SURFACES", 0, "a surface scatters light, diffusely or glossily", "light between surfaces and light that they reflect"}, receiving_surfaces},
        {{"SURFACES_IN_REACH", 0, "a surface that reflects diffusely faces a medium that scatters", "eye points, media_to_surface and its kernels"}, surfaces_in_reach},
        {{"GLOSSY_SURFACES", 0, "a surface is plastic, rough metal or rough glass", "path tracing of light from media to it"}, glossy_surfaces},
        {{"SPECULAR_SURFACES", 0, "there are mirrors or glass", "the layers of light through mirrors and glass"}, specular_surfaces},
    };
    return facts;
}

}  // namespace tyndall

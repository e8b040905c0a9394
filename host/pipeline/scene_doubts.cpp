#include "pipeline/scene_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "eye_tracing/eye_tracing.hpp"
#include "lights/light_technique.hpp"
#include "scene/text.hpp"
#include "scene/volume_values.hpp"
#include "transport/emitter.hpp"
#include "transport/random_sequence.hpp"

namespace tyndall {
namespace {

constexpr int rays_per_light = 1024;           ///< a target that fills 1 % of what the light sees is missed with probability 3e-5
constexpr double thick = 20;                   ///< mean free paths along the diagonal: from here on path tracing has the smaller error over areas (host/docs/performance.md)
constexpr double longest = 1e4, shortest = 1e-4;  ///< mean free path over the scene's size

double greatest(const Rgb& value) { return std::max({value.r, value.g, value.b}); }

std::string about(const SourceLocation& where, const std::string& sentence) { return to_string(where) + ": " + sentence; }

/// Does something beyond the end of the ray, or on its way, send light on?
bool sends_light_on(const Scene& scene, const RayWalk& walk)
{
    for (const MediumPiece& piece : walk.pieces)
        if (piece.medium != vacuum && greatest(scene.media[static_cast<std::size_t>(piece.medium)].sigma_s()) > 0) return true;
    if (!walk.found) return false;
    const Bsdf& front = scene.bsdfs[static_cast<std::size_t>(scene.shapes[static_cast<std::size_t>(walk.surface.shape)].bsdf)];
    const Bsdf& back = front.back == none ? front : scene.bsdfs[static_cast<std::size_t>(front.back)];
    const auto is = [](const Bsdf& b, std::initializer_list<Bsdf::Type> types) { return std::find(types.begin(), types.end(), b.type) != types.end(); };
    const auto reflects = [&](const Bsdf& b) {
        return greatest(b.reflectance) > 0 || (is(b, {Bsdf::Type::plastic, Bsdf::Type::rough_plastic}) && greatest(b.diffuse) > 0) ||
               (is(b, {Bsdf::Type::dielectric, Bsdf::Type::thin_dielectric, Bsdf::Type::rough_dielectric}) && greatest(b.specular_transmittance) > 0);
    };
    return reflects(front) || reflects(back);
}

bool reaches_something(const EmitterSampler& emitters, int emitter, const Visibility& visibility)
{
    for (int i = 0; i < rays_per_light; ++i) {
        RandomSequence random(1, 0, RandomStream::pilot, static_cast<std::uint64_t>(emitter) * rays_per_light + static_cast<std::uint64_t>(i));
        const Vec2 place = random.next2();
        const EmissionSample start = sample_emission(emitters, emitter, place, random.next2());
        if (greatest(start.weight) > 0 && sends_light_on(emitters.scene(), visibility.walk({start.origin, start.direction}, start.medium))) return true;
    }
    return false;
}

void doubt_lights(const Scene& scene, const Visibility& visibility, std::vector<std::string>& doubts)
{
    const EmitterSampler emitters(scene);
    for (std::size_t i = 0; i < scene.emitters.size(); ++i) {
        const Emitter& emitter = scene.emitters[i];
        if (greatest(emitter.value) <= 0)
            doubts.push_back(about(emitter.where, fmt::format("emitter {} gives no light; raise its value or remove it", in_quotes(emitter.name))));
        else if (!reaches_something(emitters, static_cast<int>(i), visibility))
            doubts.push_back(about(emitter.where, fmt::format("emitter {}: of {} rays none reaches a medium that scatters or a surface that reflects; turn it, move it or remove it",
                                                              in_quotes(emitter.name), rays_per_light)));
    }
}

void doubt_unseen_media(const Scene& scene, const Visibility& visibility, std::vector<std::string>& doubts)
{
    std::set<std::size_t> seen;
    for (const EyeSegment& segment : trace_eyes(scene, visibility, {.points = false}).segments) seen.insert(segment.medium);
    for (std::size_t i = 0; i < scene.media.size(); ++i)
        if (greatest(scene.media[i].sigma_s()) > 0 && !seen.contains(i))
            doubts.push_back(about(scene.media[i].where, fmt::format("medium {}: no camera ray crosses it; what it sends to surfaces may be seen, but if it should itself be, move the camera",
                                                                     in_quotes(scene.media[i].name))));
}

/// Length of the diagonal of what the medium fills, as far as its grid or boundaries tell; of the scene for a medium without.
double extent_of(const Scene& scene, int medium)
{
    Bounds bounds;
    if (const int density = scene.media[static_cast<std::size_t>(medium)].density; density != none) return 2 * bounds_of(scene.volumes[static_cast<std::size_t>(density)]).radius();
    for (const Shape& shape : scene.shapes) {
        if (!shape.medium_boundary || shape.interior != medium) continue;
        const Bounds b = bounds_of(shape);
        bounds.grow(b.low), bounds.grow(b.high);
    }
    return 2 * (bounds.empty() ? bounds_of(scene) : bounds).radius();
}

void doubt_medium(const Scene& scene, int index, const LightTechnique* technique, const RenderSettings& settings, std::vector<std::string>& doubts)
{
    const Medium& medium = scene.media[static_cast<std::size_t>(index)];
    const double sigma_t = greatest(largest_extinction(scene, medium)), thickness = sigma_t * extent_of(scene, index), scene_size = 2 * bounds_of(scene).radius();
    if (sigma_t <= 0) return;
    if (technique && !settings.path_layers.contains(Layer::media_to_media) && thickness > thick && greatest(medium.sigma_s()) > 0)
        doubts.push_back(about(medium.where, fmt::format("medium {} is {}{:.3g} mean free paths thick: above {:g}, path tracing tends to reach the same error over areas of 8 x 8 pixels sooner than {}, which still lead "
                                                         "pixel by pixel; --layer media_to_media=path gives it that layer, and tyndall compare measures both",
                                                         in_quotes(medium.name), medium.density == none ? "" : "up to ", thickness, thick, technique->title)));
    const double relative = 1 / (sigma_t * scene_size);  // mean free path over the scene's size
    if (relative > longest || relative < shortest)
        doubts.push_back(about(medium.where, fmt::format("medium {}: its {}mean free path is {:.3g} times the size of the scene; check the units of sigma_t and of the lengths",
                                                         in_quotes(medium.name), medium.density == none ? "" : "shortest ", relative)));
}

}  // namespace

std::vector<std::string> doubts_about(const Scene& scene, const RenderSettings& settings, const Visibility& visibility)
{
    std::vector<std::string> doubts;
    doubt_lights(scene, visibility, doubts);
    doubt_unseen_media(scene, visibility, doubts);
    for (std::size_t i = 0; i < scene.media.size(); ++i) doubt_medium(scene, static_cast<int>(i), technique_of(settings.method), settings, doubts);
    return doubts;
}

}  // namespace tyndall

#include "light_tracing/light_tracing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "parallel/parallel_for.hpp"
#include "transport/bsdf.hpp"
#include "transport/emitter.hpp"
#include "transport/lit_stretch.hpp"
#include "transport/medium.hpp"
#include "transport/phase_function.hpp"
#include "transport/sobol.hpp"

namespace tyndall {
namespace {

constexpr std::uint64_t chunk_paths = 64;     ///< per task; fixed, so that the order of the lights is
constexpr std::uint64_t pilot_paths = 4096;
constexpr int roulette_depth = 6;             ///< scattering vertices before Russian roulette begins
constexpr double most_survival = .95;         ///< even where nothing is absorbed, so that every path ends

/// What a light path met last: it decides which layer the light belongs to that eyes take from it.
class LightHistory {
public:
    void scatter_in_medium() { met_ = Met::medium, specular_ = false; }
    void scatter_at_surface(bool delta) { delta ? void(specular_ = true) : void((met_ = Met::surface, specular_ = false)); }
    /// By x1 = a place in a medium, or on a surface.
    Layer layer(bool on_surface) const
    {
        static constexpr Layer layers[3][2] = {{Layer::single, Layer::surface_direct}, {Layer::surface_to_media, Layer::surface_indirect}, {Layer::media_to_media, Layer::media_to_surface}};
        const Layer straight = layers[static_cast<std::size_t>(met_)][on_surface];
        return specular_ ? specular(straight) : straight;
    }

private:
    enum class Met { light, surface, medium } met_ = Met::light;
    bool specular_ = false;  ///< a mirror or glass since then
};

/// One light path, from its emitter until it is absorbed or leaves the scene.
class LightPath {
public:
    LightPath(const Scene& scene, const Visibility& visibility, const EmitterSampler& emitters, const LightTracingSettings& settings, std::uint64_t index)
        : scene_(scene), visibility_(visibility), settings_(settings), random_(settings.seed, settings.pass, settings.pilot ? RandomStream::pilot : RandomStream::light_path, index, settings.even)
    {
        const EmitterChoice choice = emitters.choose(random_.next());
        const Vec2 where = random_.next2(), which_way = random_.next2();
        const EmissionSample start = sample_emission(emitters, choice.emitter, where, which_way);
        ray_ = {.origin = start.origin, .direction = start.direction};
        medium_ = start.medium;
        throughput_ = start.weight / (choice.probability * static_cast<double>(settings.paths));
        reference_ = largest(throughput_);
    }

    /// deposit(segment, layer) for every piece in a medium; arrive(arrival, layer) where it meets a surface that reflects diffusely.
    template <typename Deposit, typename Arrive>
    void trace(const Deposit& deposit, const Arrive& arrive, bool arrivals)
    {
        while (largest(throughput_) > 0 && may_leave_lights()) {
            const RayWalk walk = visibility_.walk(ray_, medium_);
            const Vec2 xi = random_.next2();
            const FreeFlight flight = sample_free_flight(scene_, walk, throughput_, xi);
            leave_segments(walk, flight, deposit);
            if (arrivals && !flight.collided && walk.found) leave_arrival(walk, flight, arrive);
            if (settings_.light_segments == LightSegments::first) return;
            const bool goes_on = flight.collided ? scatter_in_medium(walk, flight) : scatter_at_surface(walk, flight);
            if (!goes_on || !survives()) return;
        }
    }

private:
    /// A light at depth d makes paths of at least d + vertices_to_come scattering vertices.
    bool may_leave_lights() const { return settings_.max_depth < 0 || depth_ + settings_.vertices_to_come <= settings_.max_depth - 1; }

    template <typename Deposit>
    void leave_segments(const RayWalk& walk, const FreeFlight& flight, const Deposit& deposit)
    {
        const bool is_short = settings_.segment_length == SegmentLength::short_;
        const Rgb share = throughput_ / (throughput_.r + throughput_.g + throughput_.b);
        Rgb before(1);
        for (std::size_t i = 0; i < walk.pieces.size(); ++i) {
            const MediumPiece& piece = walk.pieces[i];
            if (piece.medium == vacuum) continue;
            const Medium& medium = scene_.media[static_cast<std::size_t>(piece.medium)];
            const bool ends_here = is_short && flight.collided && flight.piece == i;
            const MediumLine line{.medium = medium, .origin = ray_.origin, .direction = ray_.direction, .t0 = piece.t0, .t1 = ends_here ? flight.t : piece.t1};
            const Rgb flux = throughput_ * before;
            const LitStretch lit = lit_stretch(scene_, line);
            if (lit.length > 0 && largest(flux * medium.sigma_s()) > 0) {
                const bool collides = flight.collided && flight.piece == i;
                deposit(LightPathSegment{.origin = ray_.origin + lit.start * ray_.direction, .direction = ray_.direction, .length = lit.length, .medium = piece.medium,
                                         .flux = flux, .depth = depth_, .is_short = is_short, .channel = is_short ? share * before : Rgb(0),
                                         .collision = collides ? std::max(flight.t - lit.start, 0.0) : -1, .radius = settings_.radius, .scattered = collides ? throughput_ * flight.weight : Rgb(0)}, history_.layer(false));
            }
            if (ends_here) return;
            before *= glm::exp(-lit.whole);
        }
    }

    template <typename Arrive>
    void leave_arrival(const RayWalk& walk, const FreeFlight& flight, const Arrive& arrive)
    {
        const Rgb flux = throughput_ * flight.weight;
        if (!(largest(flux) > 0) || !parts_at(scene_, {.hit = walk.surface, .in = ray_.direction}).lambertian) return;
        const double side = glm::dot(walk.surface.geometric_normal, ray_.direction) < 0 ? 1 : -1;
        const Vec3 facing = side * walk.surface.geometric_normal, normal = side * walk.surface.shading_normal;
        arrive(LightPathArrival{.position = walk.surface.position, .direction = ray_.direction, .facing = facing, .flux = flux, .depth = depth_, .radius = settings_.radius,
                                .off_surface = visibility_.leave(walk.surface, facing), .normal = normal, .reflected = flux * reflected_share(walk.surface, facing, normal),
                                .medium = walk.medium == vacuum ? static_cast<int>(scene_.media.size()) : walk.medium},
               history_.layer(true));
    }

    /// Of the power that arrives, what goes on per steradian and cosine.
    Rgb reflected_share(const Hit& hit, const Vec3& facing, const Vec3& normal) const
    {
        const double over_surface = -glm::dot(ray_.direction, facing), over_shading = -glm::dot(ray_.direction, normal);
        if (!(over_surface > 0) || !(over_shading > 0)) return Rgb(0);
        return diffuse_reflectance(scene_, hit, ray_.direction) * (std::numbers::inv_pi * over_shading / over_surface);
    }

    bool scatter_in_medium(const RayWalk& walk, const FreeFlight& flight)
    {
        medium_ = walk.pieces[flight.piece].medium;
        throughput_ *= flight.weight;
        const PhaseSample next = sample_phase(scene_.media[static_cast<std::size_t>(medium_)].phase, ray_.direction, random_.next2());
        ray_ = {.origin = ray_.origin + flight.t * ray_.direction, .direction = next.direction};
        ++depth_, history_.scatter_in_medium();
        return true;
    }

    bool scatter_at_surface(const RayWalk& walk, const FreeFlight& flight)
    {
        if (!walk.found) return false;
        const BsdfSample next = sample_bsdf(scene_, {.hit = walk.surface, .in = ray_.direction, .mode = TransportMode::importance}, random_.next2());
        throughput_ *= flight.weight * next.weight;
        medium_ = visibility_.medium_behind(walk.surface, next.direction, walk.medium);
        ray_ = {.origin = visibility_.leave(walk.surface, next.direction), .direction = next.direction};
        ++depth_, history_.scatter_at_surface(next.delta);
        return largest(throughput_) > 0;
    }

    /// Russian roulette on what is left of the path's flux.
    bool survives()
    {
        if (depth_ < roulette_depth) return true;
        const double survival = std::min(largest(throughput_) / reference_, most_survival);
        if (random_.next() >= survival) return false;
        throughput_ /= survival;
        return true;
    }

    const Scene& scene_;
    const Visibility& visibility_;
    const LightTracingSettings& settings_;
    EvenSequence random_;  ///< emitter 1, emission 4, first flight 2, first vertex 2; then independent
    Ray ray_;
    int medium_ = vacuum, depth_ = 0;
    Rgb throughput_{0};
    double reference_ = 0;
    LightHistory history_;
};

/// Appends what every path leaves to records_of(chunk, layer), which is null where nobody wants it; chunks run in parallel.
template <typename RecordsOf>
void for_each_path(const Scene& scene, const Visibility& visibility, const LightTechnique& technique, const LightTracingSettings& settings, const RecordsOf& records_of)
{
    const EmitterSampler emitters(scene);
    if (emitters.empty()) return;
    const std::uint64_t chunks = (settings.paths + chunk_paths - 1) / chunk_paths;
    parallel_for(std::uint64_t(0), chunks, [&](std::uint64_t chunk) {
        throw_if_raised(settings.stop);
        const auto deposit = [&](const LightPathSegment& segment, Layer layer) {
            if (auto* records = records_of(chunk, layer); records && technique.deposit) technique.deposit(segment, *records);
        };
        const auto arrive = [&](const LightPathArrival& arrival, Layer layer) {
            if (auto* records = records_of(chunk, layer)) technique.arrive(arrival, *records);
        };
        for (std::uint64_t path = chunk * chunk_paths; path < std::min((chunk + 1) * chunk_paths, settings.paths); ++path)
            LightPath(scene, visibility, emitters, settings, path).trace(deposit, arrive, technique.arrive != nullptr);
    });
}

}  // namespace

/// Records of all chunks, in order.
static VirtualLights joined(const std::vector<std::vector<std::byte>>& chunks, const LightTechnique& technique)
{
    VirtualLights lights;
    for (const auto& chunk : chunks) lights.records.insert(lights.records.end(), chunk.begin(), chunk.end());
    lights.count = static_cast<std::uint32_t>(lights.records.size() / technique.record_bytes);
    return lights;
}

VirtualLights trace_lights(const Scene& scene, const Visibility& visibility, const LightTechnique& technique, const LightTracingSettings& settings)
{
    std::vector<std::vector<std::byte>> chunks((settings.paths + chunk_paths - 1) / chunk_paths);
    for_each_path(scene, visibility, technique, settings, [&](std::uint64_t chunk, Layer) { return &chunks[chunk]; });
    return joined(chunks, technique);
}

std::vector<GatheredLights> trace_gathered_lights(const Scene& scene, const Visibility& visibility, const LightTechnique& technique, const LightTracingSettings& settings, const LayerSet& layers)
{
    using Chunks = std::vector<std::vector<std::byte>>;
    std::array<Chunks, layer_count> by_layer;
    for (std::size_t l = 0; l < layer_count; ++l)
        if (layers.contains(static_cast<Layer>(l))) by_layer[l].resize((settings.paths + chunk_paths - 1) / chunk_paths);
    const auto chunk_of = [&](std::uint64_t chunk, Layer layer) { return layers.contains(layer) ? &by_layer[static_cast<std::size_t>(layer)][chunk] : nullptr; };
    for_each_path(scene, visibility, technique, settings, chunk_of);
    std::vector<GatheredLights> all;
    for (std::size_t l = 0; l < layer_count; ++l)
        if (layers.contains(static_cast<Layer>(l))) all.push_back({static_cast<Layer>(l), joined(by_layer[l], technique)});
    return all;
}

std::uint64_t paths_for(const Scene& scene, const Visibility& visibility, const LightTechnique& technique, LightTracingSettings settings, std::uint32_t lights, const LayerSet& layers)
{
    settings.pilot = true, settings.even = false, settings.pass = 0, settings.paths = pilot_paths;
    double left = 0;
    if (!technique.gathered()) left = trace_lights(scene, visibility, technique, settings).count;
    else
        for (const GatheredLights& each : trace_gathered_lights(scene, visibility, technique, settings, layers)) left += each.lights.count;
    const double per_path = left / double(pilot_paths);
    if (per_path == 0) return pilot_paths;  // no light reached a medium in the pilot: look harder than the wish
    return static_cast<std::uint64_t>(std::max(std::round(lights / per_path), 1.0));
}

}  // namespace tyndall

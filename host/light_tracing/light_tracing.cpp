#include "light_tracing/light_tracing.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

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

    template <typename Deposit>
    void trace(const Deposit& deposit)
    {
        while (largest(throughput_) > 0 && may_leave_lights()) {
            const RayWalk walk = visibility_.walk(ray_, medium_);
            const Vec2 xi = random_.next2();
            const FreeFlight flight = sample_free_flight(scene_, walk, throughput_, xi);
            leave_segments(walk, flight, deposit);
            if (settings_.light_segments == LightSegments::first) return;
            const bool goes_on = flight.collided ? scatter_in_medium(walk, flight) : scatter_at_surface(walk, flight);
            if (!goes_on || !survives()) return;
        }
    }

private:
    /// A light at depth d makes paths of at least d + 2 scattering vertices.
    bool may_leave_lights() const { return settings_.max_depth < 0 || depth_ + 2 <= settings_.max_depth - 1; }

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
                                         .collision = collides ? std::max(flight.t - lit.start, 0.0) : -1, .radius = settings_.radius, .scattered = collides ? throughput_ * flight.weight : Rgb(0)});
            }
            if (ends_here) return;
            before *= glm::exp(-lit.whole);
        }
    }

    bool scatter_in_medium(const RayWalk& walk, const FreeFlight& flight)
    {
        medium_ = walk.pieces[flight.piece].medium;
        throughput_ *= flight.weight;
        const PhaseSample next = sample_phase(scene_.media[static_cast<std::size_t>(medium_)].phase, ray_.direction, random_.next2());
        ray_ = {.origin = ray_.origin + flight.t * ray_.direction, .direction = next.direction};
        ++depth_;
        return true;
    }

    bool scatter_at_surface(const RayWalk& walk, const FreeFlight& flight)
    {
        if (!walk.found) return false;
        const BsdfSample next = sample_bsdf(scene_, {.hit = walk.surface, .in = ray_.direction, .mode = TransportMode::importance}, random_.next2());
        throughput_ *= flight.weight * next.weight;
        medium_ = visibility_.medium_behind(walk.surface, next.direction, walk.medium);
        ray_ = {.origin = visibility_.leave(walk.surface, next.direction), .direction = next.direction};
        ++depth_;
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
};

/// Calls deposit(chunk, segment) for every segment of every path; chunks run in parallel.
template <typename Deposit>
void for_each_segment(const Scene& scene, const Visibility& visibility, const LightTracingSettings& settings, const Deposit& deposit)
{
    const EmitterSampler emitters(scene);
    if (emitters.empty()) return;
    const std::uint64_t chunks = (settings.paths + chunk_paths - 1) / chunk_paths;
    tbb::parallel_for(std::uint64_t(0), chunks, [&](std::uint64_t chunk) {
        throw_if_raised(settings.stop);
        for (std::uint64_t path = chunk * chunk_paths; path < std::min((chunk + 1) * chunk_paths, settings.paths); ++path)
            LightPath(scene, visibility, emitters, settings, path).trace([&](const LightPathSegment& segment) { deposit(chunk, segment); });
    });
}

}  // namespace

VirtualLights trace_lights(const Scene& scene, const Visibility& visibility, const LightTechnique& technique, const LightTracingSettings& settings)
{
    std::vector<std::vector<std::byte>> chunks((settings.paths + chunk_paths - 1) / chunk_paths);
    for_each_segment(scene, visibility, settings, [&](std::uint64_t chunk, const LightPathSegment& segment) { technique.deposit(segment, chunks[chunk]); });
    VirtualLights lights;
    for (const auto& chunk : chunks) lights.records.insert(lights.records.end(), chunk.begin(), chunk.end());
    lights.count = static_cast<std::uint32_t>(lights.records.size() / technique.record_bytes);
    return lights;
}

std::uint64_t paths_for(const Scene& scene, const Visibility& visibility, const LightTechnique& technique, LightTracingSettings settings, std::uint32_t lights)
{
    settings.pilot = true, settings.even = false, settings.pass = 0, settings.paths = pilot_paths;
    const double per_path = double(trace_lights(scene, visibility, technique, settings).count) / double(pilot_paths);
    if (per_path == 0) return pilot_paths;  // no light reached a medium in the pilot: look harder than the wish
    return static_cast<std::uint64_t>(std::max(std::round(lights / per_path), 1.0));
}

}  // namespace tyndall

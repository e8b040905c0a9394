#include "path_tracing/path_tracing.hpp"

#include <algorithm>
#include <tuple>

#include "parallel/parallel_for.hpp"
#include "path_tracing/layer_track.hpp"
#include "transport/bsdf.hpp"
#include "transport/camera.hpp"
#include "transport/emitter.hpp"
#include "transport/medium.hpp"
#include "transport/phase_function.hpp"
#include "transport/warp.hpp"

namespace tyndall {
namespace {

using Vertex = LayerTrack::Vertex;

constexpr int roulette_vertices = 8;  ///< scattering vertices before Russian roulette begins
/// Also where nothing is absorbed, so that every path ends; high, because each step below 1 costs variance there.
constexpr double most_survival = .995;

/// What all paths of a pass share.
struct Shared {
    const Scene& scene;
    const Visibility& visibility;
    const PathTracingSettings& settings;
    const EmitterSampler emitters;
    std::vector<int> surroundings{};  ///< the emitters that a ray meets which leaves the scene
};

/// A path that begins at the camera and grows towards the lights. Every light that it meets by chance and every connection to a light adds
/// to a layer.
class CameraPath {
public:
    CameraPath(const Shared& shared, PassImage& image, std::size_t pixel, const CameraSample& start)
        : shared_(shared),
          scene_(shared.scene),
          image_(image),
          pixel_(pixel),
          random_(shared.settings.seed, shared.settings.pass, RandomStream::path, pixel),
          ray_(start.ray),
          medium_(start.medium)
    {
    }

    void trace()
    {
        if (shared_.settings.max_depth == 0) return;
        do {
            const RayWalk walk = shared_.visibility.walk(ray_, medium_);
            add_met_light(walk);
            if (!may_scatter()) return;
            const FreeFlight flight = sample_free_flight(scene_, walk, throughput_, random_.next2());
            throughput_ *= flight.weight;
            if (!(largest(throughput_) > 0)) return;
            if (!(flight.collided ? scatter_in_medium(walk, flight) : scatter_at_surface(walk))) return;
        } while (survives());
    }

private:
    bool may_scatter() const { return shared_.settings.max_depth < 0 || vertices_ < shared_.settings.max_depth - 1; }
    LayerSet wanted() const
    {
        const auto& [layers, at_first, at_second] = std::tie(shared_.settings.layers, shared_.settings.glossy_only, shared_.settings.glossy_lights);
        if (!track_.scattered()) return layers;
        LayerSet wanted = layers.without(at_first | at_second);
        if (begins_glossy_) wanted = wanted | (layers & at_first);
        if (!track_.scattered_twice() || glossy_light_) wanted = wanted | (layers & at_second);
        return wanted;
    }
    bool wants(Layer layer) const { return wanted().contains(layer); }
    bool wants_more() const { return !(track_.reachable() & wanted()).empty(); }
    void add(Layer layer, const Rgb& radiance) { image_[layer][pixel_] += radiance; }

    /// Share of a light met by chance, the rest being next-event estimation's; `light_pdf` is that one's density per steradian.
    double chance_weight(double light_pdf) const { return last_pdf_ > 0 ? mis_weight(last_pdf_, light_pdf) : 1; }

    void add_met_light(const RayWalk& walk)
    {
        const Layer layer = track_.of_light();
        if (!wants(layer)) return;
        Rgb radiance(0);
        if (walk.found) {
            radiance = emitted_radiance(scene_, walk.surface, ray_.direction);
            if (largest(radiance) > 0) radiance *= chance_weight(pdf_direct(shared_.emitters, ray_.origin, walk.surface));
        } else {
            for (const int i : shared_.surroundings)
                radiance += radiance_from_outside(scene_, scene_.emitters[i], ray_.direction) * chance_weight(pdf_direct_outside(shared_.emitters, i, ray_.direction));
        }
        if (largest(radiance) > 0) add(layer, throughput_ * radiance * transmittance_of(scene_, walk));
    }

    /// Light that arrives at the vertex straight from an emitter; scatter(direction) gives phase function or BSDF x cosine and its sampling
    /// density.
    template <class Scatter>
    void add_connection(const Scatter& scatter)
    {
        if (shared_.emitters.empty() || !wants(track_.of_light())) return;
        if (vertices_ > 1 || scene_.emitters.size() > most_emitters_at_once) return add_connection(scatter, shared_.emitters.choose(random_.next()), true);
        for (std::size_t e = 0; e < scene_.emitters.size(); ++e) {
            const int emitter = static_cast<int>(e);
            if (shared_.emitters.probability(emitter) > 0) add_connection(scatter, {emitter, shared_.emitters.probability(emitter)}, false);
        }
    }

    /// A connection to one emitter, chosen at random or one of all. The share that multiple importance sampling leaves to it is the same in both cases.
    template <class Scatter>
    void add_connection(const Scatter& scatter, const EmitterChoice& choice, bool at_random)
    {
        const DirectSample light = sample_direct(shared_.emitters, choice.emitter, ray_.origin, random_.next2());
        if (!(largest(light.weight) > 0)) return;
        const auto [value, pdf] = scatter(light.direction);
        const Rgb radiance = throughput_ * value * light.weight / (at_random ? choice.probability : 1);
        if (!(largest(radiance) > 0)) return;
        const double share = light.delta ? 1 : mis_weight(light.pdf * choice.probability, pdf);
        add(track_.of_light(), radiance * share * transmittance_to(shared_.visibility, scene_, ray_.origin, medium_, light));
    }

    struct Scattered {
        Rgb value;
        double pdf;
    };

    bool scatter_in_medium(const RayWalk& walk, const FreeFlight& flight)
    {
        track_.scatter(Vertex::medium), ++vertices_;
        if (!wants_more()) return false;
        const Vec3 in = ray_.direction;
        medium_ = walk.pieces[flight.piece].medium;
        const PhaseFunction& phase = scene_.media[medium_].phase;
        ray_ = {.origin = ray_.origin + flight.t * in, .direction = in};
        add_connection([&](const Vec3& out) {
            const double p = evaluate_phase(phase, in, out);
            return Scattered{Rgb(p), p};
        });
        const PhaseSample next = sample_phase(phase, in, random_.next2());
        ray_.direction = next.direction, last_pdf_ = next.pdf;
        return true;
    }

    bool scatter_at_surface(const RayWalk& walk)
    {
        if (!walk.found) return false;
        const Hit& hit = walk.surface;
        const Arrival arrival{.hit = hit, .in = ray_.direction};
        const SurfaceParts parts = parts_at(scene_, arrival);
        ++vertices_;
        const LayerTrack before = track_;
        if (parts.scattering) {
            if (!track_.scattered()) begins_glossy_ = !parts.lambertian;
            else if (!track_.scattered_twice()) glossy_light_ = !parts.lambertian;
            track_.scatter(Vertex::surface);
            if (wants_more()) connect_from_surface(arrival, parts, walk.medium);
        }
        const BsdfSample next = sample_bsdf(scene_, arrival, random_.next2());
        if (next.delta) track_ = before, track_.pass_specular();
        if (!wants_more()) return false;
        throughput_ *= next.weight;
        if (!(largest(throughput_) > 0)) return false;
        stand_at(hit, next.direction, walk.medium);
        ray_.direction = next.direction, last_pdf_ = next.pdf;
        return true;
    }

    /// Sets the ray's origin and medium to the side of `direction`.
    void stand_at(const Hit& hit, const Vec3& direction, int medium)
    {
        medium_ = shared_.visibility.medium_behind(hit, direction, medium);
        ray_ = {.origin = shared_.visibility.leave(hit, direction), .direction = ray_.direction};
    }

    /// Connections start where the path came from; those through the surface, from its other side, one rounding of the hit further on.
    void connect_from_surface(const Arrival& arrival, const SurfaceParts& parts, int medium)
    {
        if (parts.lambertian && diffuse_reflectance(scene_, arrival.hit, arrival.in) == Rgb(0)) return;
        stand_at(arrival.hit, -arrival.in, medium);
        add_connection([&](const Vec3& out) {
            if (parts.through) stand_at(arrival.hit, out, medium);
            return Scattered{evaluate_bsdf(scene_, arrival, out), pdf_bsdf(scene_, arrival, out)};
        });
    }

    /// Russian roulette on what is left of the path's throughput.
    bool survives()
    {
        if (vertices_ < roulette_vertices) return true;
        const double survival = std::min(largest(throughput_), most_survival);
        if (random_.next() >= survival) return false;
        throughput_ /= survival;
        return true;
    }

    const Shared& shared_;
    const Scene& scene_;
    PassImage& image_;
    std::size_t pixel_;
    RandomSequence random_;
    Ray ray_;
    int medium_;
    Rgb throughput_{1};
    LayerTrack track_;
    bool begins_glossy_ = false;  ///< the path's first scattering vertex is on a surface that is not lambertian
    bool glossy_light_ = false;   ///< its second is
    int vertices_ = 0;     ///< scattering vertices so far, mirrors and glass included
    double last_pdf_ = 0;  ///< per steradian, of ray_.direction at ray_.origin; 0: camera, mirror or glass, where no connection competes
};

}  // namespace

void trace_paths(const Scene& scene, const Visibility& visibility, const PathTracingSettings& settings, PassImage& image)
{
    if (settings.layers.empty()) return;
    Shared shared{.scene = scene, .visibility = visibility, .settings = settings, .emitters = EmitterSampler(scene)};
    for (std::size_t i = 0; i < scene.emitters.size(); ++i)
        if (all_around(scene.emitters[i])) shared.surroundings.push_back(static_cast<int>(i));
    visibility.in_arena([&] {
        parallel_for(0, image.height, [&](int y) {
            throw_if_raised(settings.stop);
            for (int x = 0; x < image.width; ++x) {
                const CameraSample start = sample_camera(scene.camera, x, y, settings.seed, settings.pass);
                CameraPath(shared, image, static_cast<std::size_t>(y) * image.width + x, start).trace();
            }
        });
    });
}

}  // namespace tyndall

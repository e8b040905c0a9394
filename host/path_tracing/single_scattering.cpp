#include "path_tracing/single_scattering.hpp"

#include <algorithm>

#include "parallel/parallel_for.hpp"
#include "path_tracing/scatter_distances.hpp"
#include "transport/bsdf.hpp"
#include "transport/camera.hpp"
#include "transport/emitter.hpp"
#include "transport/lit_stretch.hpp"
#include "transport/medium.hpp"
#include "transport/phase_function.hpp"

namespace tyndall {
namespace {

constexpr int roulette_mirrors = 8;    ///< mirrors and glass before Russian roulette begins
constexpr double most_survival = .95;  ///< so that total internal reflection ends

struct Shared {
    const Scene& scene;
    const Visibility& visibility;
    const PathTracingSettings& settings;
    const EmitterSampler emitters;
};

/// A stretch of the camera path inside one medium that scatters.
struct Stretch {
    const Medium& medium;
    int medium_index;
    Vec3 origin, direction;
    double length;
    Rgb throughput;  ///< up to its origin
    ScatterDistances distances;

    Stretch(const Scene& scene, const MediumLine& line, int index, const Rgb& arriving, const Rgb& depth)
        : medium(line.medium), medium_index(index), origin(line.origin), direction(line.direction), length(line.t1), throughput(arriving), distances(scene, line, arriving, depth)
    {
    }
};

/// Where on a stretch to scatter: half way between "as the light sees it" and "as it is lit through": the first alone while it is thin.
struct Chosen {
    double u;
    PointOnStretch point;  ///< there
    double density;        ///< per length, times the squared distance to the light if that has a place
};

/// One camera sample's single scattering.
class SinglePath {
public:
    SinglePath(const Shared& shared, std::uint64_t pixel)
        : shared_(shared), scene_(shared.scene), random_(shared.settings.seed, shared.settings.pass, RandomStream::single, pixel)
    {
    }

    Rgb trace(const CameraSample& start)
    {
        Ray ray = start.ray;
        int medium = start.medium;
        Rgb throughput(1), radiance(0);
        for (int mirrors = 0; may_scatter(mirrors) && largest(throughput) > 0; ++mirrors) {
            const RayWalk walk = shared_.visibility.walk(ray, medium);
            radiance += along(walk, ray, throughput);
            if (!walk.found || !parts_at(scene_, {.hit = walk.surface, .in = ray.direction}).specular) break;
            const BsdfSample next = sample_specular(scene_, {.hit = walk.surface, .in = ray.direction}, random_.next2());
            throughput *= next.weight * transmittance_of(scene_, walk) / survival(mirrors, throughput);
            medium = shared_.visibility.medium_behind(walk.surface, next.direction, walk.medium);
            ray = {.origin = shared_.visibility.leave(walk.surface, next.direction), .direction = next.direction};
        }
        return radiance;
    }

private:
    bool may_scatter(int mirrors) const { return shared_.settings.max_depth < 0 || mirrors + 1 <= shared_.settings.max_depth - 1; }

    /// Probability with which the path goes on; infinity (throughput becomes 0) if it does not.
    double survival(int mirrors, const Rgb& throughput)
    {
        if (mirrors < roulette_mirrors) return 1;
        const double probability = std::min(largest(throughput), most_survival);
        return random_.next() < probability ? probability : std::numeric_limits<double>::infinity();
    }

    Rgb along(const RayWalk& walk, const Ray& ray, const Rgb& throughput)
    {
        Rgb depth(0), radiance(0);
        for (const MediumPiece& piece : walk.pieces) {
            if (piece.medium == vacuum) continue;
            const Medium& medium = scene_.media[piece.medium];
            const MediumLine line{.medium = medium, .origin = ray.origin, .direction = ray.direction, .t0 = piece.t0, .t1 = piece.t1};
            const LitStretch lit = lit_stretch(scene_, line, depth);
            const Rgb arriving = throughput * glm::exp(-depth);
            if (lit.length > 0 && largest(arriving * medium.sigma_s()) > 0)
                radiance += scatter(Stretch(scene_, {.medium = medium, .origin = ray.origin + lit.start * ray.direction, .direction = ray.direction, .t0 = 0, .t1 = lit.length},
                                            piece.medium, arriving, lit.depth));
            depth += lit.whole;
        }
        return radiance;
    }

    /// Light of all emitters, or of one chosen at random where there are many.
    Rgb scatter(const Stretch& stretch)
    {
        if (stretch.distances.empty()) return Rgb(0);
        if (scene_.emitters.size() > most_emitters_at_once) {
            const EmitterChoice choice = shared_.emitters.choose(random_.next());
            return light_from(stretch, choice.emitter) / choice.probability;
        }
        Rgb lit(0);
        for (std::size_t e = 0; e < scene_.emitters.size(); ++e)
            if (shared_.emitters.probability(static_cast<int>(e)) > 0) lit += light_from(stretch, static_cast<int>(e));
        return lit;
    }

    Rgb light_from(const Stretch& stretch, int emitter)
    {
        return scene_.emitters[emitter].outside() ? light_from_outside(stretch, emitter) : light_from_point(stretch, emitter);
    }

    Chosen choose_distance(const Stretch& stretch, const Vec3& light)
    {
        const SeenStretch seen = see_stretch(light - stretch.origin, stretch.direction, stretch.length);
        const double by_angle = 1 / (1 + std::min(stretch.distances.thickness(), 1.0));
        const double which = random_.next();
        const Vec2 xi = random_.next2();
        const double u = which < by_angle ? sample_angle(seen, xi.y) : stretch.distances.sample(xi);
        const PointOnStretch point = stretch.distances.at(u);
        const double square = seen.distance * seen.distance + (u - seen.foot) * (u - seen.foot);
        return {.u = u, .point = point, .density = by_angle * pdf_angle_times_square(seen) + (1 - by_angle) * stretch.distances.pdf(u, point) * square};
    }

    /// What of `arriving` light the point sends to the camera, before transmittance and visibility of the light.
    Rgb scattered(const Stretch& stretch, const PointOnStretch& point, const Vec3& to_light) const
    {
        const double phase = evaluate_phase(stretch.medium.phase, stretch.direction, to_light);
        return stretch.throughput * point.sigma_s * glm::exp(-point.depth) * phase;
    }

    Rgb light_from_point(const Stretch& stretch, int emitter)
    {
        const EmitterPoint point = shared_.emitters.sample_point(emitter, random_.next2());
        const Chosen chosen = choose_distance(stretch, point.position);
        const Vec3 x = stretch.origin + chosen.u * stretch.direction, to_light = point.position - x;
        const double distance = glm::length(to_light);
        if (distance == 0) return Rgb(0);  // a direction does not exist; the set of such points has no measure
        const Vec3 direction = to_light / distance;
        const Rgb radiance =
            scattered(stretch, chosen.point, direction) * intensity(scene_.emitters[emitter], point, -direction) / (point.pdf * chosen.density);
        return largest(radiance) > 0 ? radiance * shared_.visibility.transmittance(x, stretch.medium_index, point.position) : Rgb(0);
    }

    Rgb light_from_outside(const Stretch& stretch, int emitter)
    {
        const double u = stretch.distances.sample(random_.next2());
        const PointOnStretch point = stretch.distances.at(u);
        const double density = stretch.distances.pdf(u, point);
        if (!(density > 0)) return Rgb(0);  // where a grid is 0, which only rounding can reach
        const Vec3 x = stretch.origin + u * stretch.direction;
        const DirectSample light = sample_direct(shared_.emitters, emitter, x, random_.next2());
        const Rgb radiance = scattered(stretch, point, light.direction) * light.weight / density;
        return largest(radiance) > 0 ? radiance * transmittance_to(shared_.visibility, scene_, x, stretch.medium_index, light) : Rgb(0);
    }

    const Shared& shared_;
    const Scene& scene_;
    RandomSequence random_;
};

}  // namespace

void trace_single(const Scene& scene, const Visibility& visibility, const PathTracingSettings& settings, PassImage& image)
{
    const Shared shared{.scene = scene, .visibility = visibility, .settings = settings, .emitters = EmitterSampler(scene)};
    if (shared.emitters.empty()) return;
    visibility.in_arena([&] {
        parallel_for(0, image.height, [&](int y) {
            throw_if_raised(settings.stop);
            for (int x = 0; x < image.width; ++x) {
                const std::size_t pixel = static_cast<std::size_t>(y) * image.width + x;
                image[Layer::single][pixel] +=
                    SinglePath(shared, pixel).trace(sample_camera(scene.camera, x, y, settings.seed, settings.pass));
            }
        });
    });
}

}  // namespace tyndall

#include "eye_tracing/eye_tracing.hpp"

#include <algorithm>
#include <numbers>

#include "parallel/parallel_for.hpp"
#include "transport/bsdf.hpp"
#include "transport/camera.hpp"
#include "transport/lit_stretch.hpp"
#include "transport/medium.hpp"
#include "transport/random_sequence.hpp"

namespace tyndall {
namespace {

constexpr int roulette_depth = 8;      ///< mirrors and glass before Russian roulette begins
constexpr double most_survival = .95;  ///< so that total internal reflection ends

float f(double x) { return static_cast<float>(x); }

struct Row {
    std::vector<EyeSegment> segments;
    std::vector<EyePoint> points;
};

/// A pass of its own, as far as random numbers go, for every camera sample after the first.
std::uint64_t numbered(std::uint64_t pass, int sample) { return pass | static_cast<std::uint64_t>(sample) << 48; }

/// The camera path of one sample of a pixel.
class EyePath {
public:
    EyePath(const Scene& scene, const Visibility& visibility, const EyeTracingSettings& settings, EyeRecords& all, Row& row, int x, int y, int sample)
        : scene_(scene),
          visibility_(visibility),
          settings_(settings),
          features_(all.features),
          row_(row),
          pixel_(static_cast<uint>(y * scene.camera.crop_width + x)),
          first_sample_(sample == 0),
          random_(settings.seed, numbered(settings.pass, sample), RandomStream::pairs, pixel_)
    {
        const CameraSample start = sample_camera(scene.camera, x, y, settings.seed, numbered(settings.pass, sample));
        ray_ = start.ray, medium_ = start.medium, along_axis_ = glm::dot(start.ray.direction, Vec3(scene.camera.to_world[2])), near_ = start.near;
    }

    void trace()
    {
        for (bool first = true; largest(throughput_) > 0; first = false) {
            const RayWalk walk = visibility_.walk(ray_, medium_);
            const bool scatters = may_scatter() && (settings_.segments || settings_.points);
            look_through(walk, scatters);
            if (first && first_sample_) note_features(walk);
            if (!scatters) return;
            add_segments(walk);
            if (!walk.found) return;
            throughput_ *= glm::exp(-depth_);
            const SurfaceParts parts = parts_at(scene_, {.hit = walk.surface, .in = ray_.direction});
            if (parts.lambertian) return add_point(walk);
            if (!parts.specular || !pass_specular(walk)) return;
        }
    }

private:
    bool may_scatter() const { return settings_.max_depth < 0 || vertices_ + settings_.vertices_to_come <= settings_.max_depth - 1; }

    /// What lies along the pieces, where somebody will ask: once, because a walk through a grid is what a camera path costs most.
    void look_through(const RayWalk& walk, bool scatters)
    {
        stretches_.clear();
        depth_ = Rgb(0);
        if (!scatters || !(settings_.segments || walk.found)) return;
        for (const MediumPiece& piece : walk.pieces) {
            stretches_.push_back(piece.medium == vacuum ? LitStretch{} : lit_stretch(scene_, line_of(walk, piece)));
            depth_ += stretches_.back().whole;
        }
    }

    MediumLine line_of(const RayWalk& walk, const MediumPiece& piece) const
    {
        return {.medium = scene_.media[static_cast<std::size_t>(piece.medium)], .origin = walk.origin, .direction = walk.direction, .t0 = piece.t0, .t1 = piece.t1};
    }

    uint next_key() { return static_cast<uint>(random_.next() * 4294967296.0); }

    void note_features(const RayWalk& walk)
    {
        if (walk.found) {
            features_.depth[pixel_] = (near_ + glm::dot(walk.surface.position - ray_.origin, ray_.direction)) * along_axis_ * scene_.unit;
            const double side = glm::dot(walk.surface.shading_normal, ray_.direction) < 0 ? 1 : -1;
            features_.normal[pixel_] = side * walk.surface.shading_normal;
            features_.albedo[pixel_] = diffuse_reflectance(scene_, walk.surface, ray_.direction);
        }
        for (std::size_t i = 0; i < walk.pieces.size(); ++i)
            if (walk.pieces[i].medium != vacuum && extinguishes(walk, i)) {
                features_.albedo[pixel_] = scene_.media[static_cast<std::size_t>(walk.pieces[i].medium)].albedo;
                return;
            }
    }

    /// Does the piece run through something that its medium is made of?
    bool extinguishes(const RayWalk& walk, std::size_t piece) const
    {
        const MediumLine line = line_of(walk, walk.pieces[piece]);
        if (line.medium.density == none) return line.medium.sigma_t != Rgb(0);
        if (!stretches_.empty()) return largest(stretches_[piece].whole) > 0;
        return reach_depth(scene_, line, 0, 0).reached || reach_depth(scene_, line, 1, 0).reached || reach_depth(scene_, line, 2, 0).reached;
    }

    void add_segments(const RayWalk& walk)
    {
        Rgb throughput = throughput_;
        for (std::size_t i = 0; i < walk.pieces.size(); ++i) {
            const MediumPiece& piece = walk.pieces[i];
            if (piece.medium == vacuum) continue;
            const uint key = next_key();  // also if nobody asks for segments: the numbers that follow are the same then
            if (!settings_.segments) continue;
            const Medium& medium = scene_.media[static_cast<std::size_t>(piece.medium)];
            const LitStretch& lit = stretches_[i];
            const Vec3 origin = ray_.origin + lit.start * ray_.direction, d = ray_.direction;
            if (lit.length > 0 && largest(throughput * medium.sigma_s()) > 0)
                row_.segments.push_back({f(origin.x), f(origin.y), f(origin.z), f(lit.length), f(d.x), f(d.y), f(d.z), static_cast<uint>(piece.medium), f(throughput.r),
                                         f(throughput.g), f(throughput.b), static_cast<uint>(vertices_), pixel_, key, 0, 0});
            throughput *= glm::exp(-lit.whole);
        }
    }

    void add_point(const RayWalk& walk)
    {
        const Rgb reflected = throughput_ * diffuse_reflectance(scene_, walk.surface, ray_.direction) * std::numbers::inv_pi;
        if (!settings_.points || largest(reflected) == 0) return;
        const double side = glm::dot(walk.surface.geometric_normal, ray_.direction) < 0 ? 1 : -1;
        const Vec3 facing = side * walk.surface.geometric_normal, normal = side * walk.surface.shading_normal;
        const Vec3 position = visibility_.leave(walk.surface, facing);
        row_.points.push_back({f(position.x), f(position.y), f(position.z), walk.medium == vacuum ? NO_MEDIUM : static_cast<uint>(walk.medium), f(normal.x), f(normal.y),
                               f(normal.z), static_cast<uint>(vertices_), f(reflected.r), f(reflected.g), f(reflected.b), pixel_, f(facing.x), f(facing.y), f(facing.z),
                               next_key()});
    }

    bool pass_specular(const RayWalk& walk)
    {
        const BsdfSample next = sample_specular(scene_, {.hit = walk.surface, .in = ray_.direction}, random_.next2());
        throughput_ *= next.weight;
        if (++vertices_ >= roulette_depth) {
            const double survival = std::min(largest(throughput_), most_survival);
            if (random_.next() >= survival) return false;
            throughput_ /= survival;
        }
        medium_ = visibility_.medium_behind(walk.surface, next.direction, walk.medium);
        ray_ = {.origin = visibility_.leave(walk.surface, next.direction), .direction = next.direction, .t_max = ray_.t_max};
        return true;
    }

    const Scene& scene_;
    const Visibility& visibility_;
    const EyeTracingSettings& settings_;
    PixelFeatures& features_;
    Row& row_;
    uint pixel_;
    bool first_sample_;
    RandomSequence random_;
    Ray ray_;
    int medium_ = vacuum, vertices_ = 0;
    boost::container::small_vector<LitStretch, 8> stretches_;  ///< of the pieces of the present ray
    Rgb depth_{0};                                             ///< optical depth of all of them
    double along_axis_ = 1, near_ = 0;
    Rgb throughput_{1};
};

}  // namespace

EyeRecords trace_eyes(const Scene& scene, const Visibility& visibility, const EyeTracingSettings& settings)
{
    const int width = scene.camera.crop_width, height = scene.camera.crop_height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    EyeRecords all;
    all.features = {std::vector<Rgb>(pixels, Rgb(0)), std::vector<Vec3>(pixels, Vec3(0)), std::vector<double>(pixels, 0)};
    for (int sample = 0; sample < settings.samples; ++sample) {
        std::vector<Row> rows(static_cast<std::size_t>(height));
        parallel_for(0, height, [&](int y) {
            throw_if_raised(settings.stop);
            for (int x = 0; x < width; ++x) EyePath(scene, visibility, settings, all, rows[static_cast<std::size_t>(y)], x, y, sample).trace();
        });
        for (const Row& row : rows) {
            all.segments.insert(all.segments.end(), row.segments.begin(), row.segments.end());
            all.points.insert(all.points.end(), row.points.begin(), row.points.end());
        }
        all.segment_ends.push_back(all.segments.size()), all.point_ends.push_back(all.points.size());
    }
    return all;
}

}  // namespace tyndall

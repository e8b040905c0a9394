#pragma once
/// Scenes written as text, rendered whole, with error bars. Passes are independent; pixels of a pass share their lights, so an image's mean
/// is judged by its scatter over passes.
#include <fmt/format.h>

#include <array>
#include <memory>
#include <string>

#include "../transport/statistics.hpp"
#include "pipeline/render.hpp"
#include "scene/load_scene.hpp"

namespace tyndall::test {

/// A box-filtered square film; `fov` in degrees; inside the medium named by `medium` if that is not empty.
struct Sensor {
    Vec3 origin{0, 0, 4}, target{0};
    double fov = 30;
    int pixels = 12;
    std::string medium = {};
    double near_clip = 1e-4, far_clip = 1e4;
};

/// %.17g: reading gives the same double.
inline std::string number(double x) { return fmt::format("{:.17g}", x); }
inline std::string triple(const Vec3& v) { return number(v.x) + " " + number(v.y) + " " + number(v.z); }
inline std::string rgb(const std::string& name, const Rgb& v) { return "<rgb name=\"" + name + "\" value=\"" + triple(v) + "\"/>"; }
inline std::string float_of(const std::string& name, double x) { return "<float name=\"" + name + "\" value=\"" + number(x) + "\"/>"; }
inline std::string medium_ref(const std::string& medium) { return medium.empty() ? "" : "<ref id=\"" + medium + "\"/>"; }
inline std::string side_ref(const std::string& side, const std::string& medium)
{
    return medium.empty() ? "" : "<ref name=\"" + side + "\" id=\"" + medium + "\"/>";
}

inline std::string sensor(const Sensor& s)
{
    return "<sensor type=\"perspective\">" + float_of("fov", s.fov) + float_of("near_clip", s.near_clip) +
           float_of("far_clip", s.far_clip) + "<transform name=\"to_world\"><lookat origin=\"" + triple(s.origin) + "\" target=\"" +
           triple(s.target) + "\" up=\"0 1 0\"/></transform>" + medium_ref(s.medium) +
           fmt::format(
               R"(<film type="hdrfilm"><integer name="width" value="{0}"/><integer name="height" value="{0}"/><rfilter type="box"/></film></sensor>)",
               s.pixels);
}

/// g = 0: isotropic.
inline std::string medium(const std::string& id, const Rgb& sigma_t, const Rgb& albedo, double g = 0)
{
    const std::string phase = g == 0 ? "<phase type=\"isotropic\"/>" : "<phase type=\"hg\">" + float_of("g", g) + "</phase>";
    return "<medium type=\"homogeneous\" id=\"" + id + "\">" + rgb("sigma_t", sigma_t) + rgb("albedo", albedo) + phase + "</medium>";
}

inline const std::string null_surface = "<bsdf type=\"null\"/>";
inline std::string diffuse(const Rgb& reflectance)
{
    return "<bsdf type=\"twosided\"><bsdf type=\"diffuse\">" + rgb("reflectance", reflectance) + "</bsdf></bsdf>";
}

/// An axis-aligned box; `content` is its surface, media, emitter.
inline std::string box(const Vec3& low, const Vec3& high, const std::string& content)
{
    return "<shape type=\"cube\"><transform name=\"to_world\"><scale value=\"" + triple(.5 * (high - low)) + "\"/><translate value=\"" +
           triple(.5 * (low + high)) + "\"/></transform>" + content + "</shape>";
}
inline std::string container(const Vec3& low, const Vec3& high, const std::string& interior, const std::string& exterior = "")
{
    return box(low, high, null_surface + side_ref("interior", interior) + side_ref("exterior", exterior));
}
inline std::string sphere(const Vec3& centre, double radius, const std::string& content)
{
    return "<shape type=\"sphere\"><point name=\"center\" value=\"" + triple(centre) + "\"/>" + float_of("radius", radius) + content +
           "</shape>";
}
/// Faces up, or down.
inline std::string horizontal(const Vec3& centre, double half, bool up, const std::string& content)
{
    return "<shape type=\"rectangle\"><transform name=\"to_world\"><scale value=\"" + triple({half, half, 1}) +
           "\"/><rotate x=\"1\" angle=\"" + (up ? "-90" : "90") + "\"/><translate value=\"" + triple(centre) + "\"/></transform>" +
           content + "</shape>";
}
inline std::string glow(const Rgb& radiance, const std::string& medium = "")
{
    return "<emitter type=\"area\">" + rgb("radiance", radiance) + medium_ref(medium) + "</emitter>";
}
inline std::string point_light(const Vec3& position, const Rgb& intensity, const std::string& medium = "")
{
    return "<emitter type=\"point\"><point name=\"position\" value=\"" + triple(position) + "\"/>" + rgb("intensity", intensity) +
           medium_ref(medium) + "</emitter>";
}
inline std::string constant_light(const Rgb& radiance) { return "<emitter type=\"constant\">" + rgb("radiance", radiance) + "</emitter>"; }

inline Scene scene_of(const std::string& body) { return parse_scene("<scene version=\"3.0.0\">" + body + "</scene>", ".", "scene.xml"); }

inline LayerSet only(Layer layer) { return LayerSet().add(layer); }

/// What a render gives, and the mean over its pixels, by layer and channel, with the scatter over passes.
struct WholeRender {
    std::array<std::array<Mean, 3>, layer_count> means;
    std::array<Mean, 3> beauty;
    std::shared_ptr<RenderOutcome> outcome;

    const Mean& operator()(Layer layer, int channel = 1) const
    {
        return means[static_cast<std::size_t>(layer)][static_cast<std::size_t>(channel)];
    }
    const Film& film() const { return outcome->film; }
    const Report& report() const { return outcome->report; }
};

inline Rgb mean_over_pixels(const std::vector<Rgb>& image)
{
    Rgb sum(0);
    for (const Rgb& pixel : image) sum += pixel;
    return image.empty() ? sum : sum / double(image.size());
}

/// Renders and expects an empty ledger.
inline WholeRender render_whole(const Scene& scene, const RenderSettings& settings)
{
    WholeRender result;
    std::array<Rgb, layer_count> before{};
    const auto add_pass = [&](const Progress& progress, const Film& film) {
        Rgb beauty(0);
        for (std::size_t l = 0; l < layer_count; ++l) {
            const Rgb sum = mean_over_pixels(film.mean(static_cast<Layer>(l))) * double(progress.passes_done), pass = sum - before[l];
            for (int c = 0; c < 3; ++c) result.means[l][static_cast<std::size_t>(c)].add(pass[c]);
            before[l] = sum, beauty += pass;
        }
        for (int c = 0; c < 3; ++c) result.beauty[static_cast<std::size_t>(c)].add(beauty[c]);
        return true;
    };
    result.outcome = std::make_shared<RenderOutcome>(render(scene, settings, add_pass));
    EXPECT_EQ(result.film().not_finite().count, 0u);
    EXPECT_EQ(result.report().ledger.not_finite_pairs, 0u);
    EXPECT_EQ(result.report().ledger.runaway_walks, 0u);
    EXPECT_EQ(result.report().ledger.unsafe_shadow_segments, 0u);
    return result;
}

/// Layers of `a` and `b` (layers of `b` together with their specular parts if `whole`) agree; each that `a` has is known to `precision`
/// (one standard error).
inline void expect_layers_agree(const WholeRender& a, const WholeRender& b, std::initializer_list<Layer> layers, double precision,
                                int channel = 1)
{
    for (const Layer layer : layers) {
        const Mean &x = a(layer, channel), &y = b(layer, channel);
        const std::string what = std::string(name(layer)) + ", channel " + std::to_string(channel);
        expect_same(x, y, what.c_str());
        EXPECT_GT(x.value(), 0) << what;
        EXPECT_LT(x.error(), precision * y.value()) << what << ": the test is too weak";
        EXPECT_LT(y.error(), precision * y.value()) << what << ": the test is too weak";
    }
}

inline void expect_same_bytes(const Film& a, const Film& b, Layer layer) { EXPECT_EQ(a.mean(layer), b.mean(layer)) << name(layer); }
inline void expect_same_bytes(const Film& a, const Film& b)
{
    for (std::size_t l = 0; l < layer_count; ++l) expect_same_bytes(a, b, static_cast<Layer>(l));
    EXPECT_EQ(a.variance_of_mean(), b.variance_of_mean());
}

/// Largest difference of two images over the largest value of the second.
inline double largest_difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b)
{
    double difference = 0, largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c)
            difference = std::max(difference, std::abs(a[i][c] - b[i][c])), largest = std::max(largest, std::abs(b[i][c]));
    return largest == 0 ? difference : difference / largest;
}

}  // namespace tyndall::test

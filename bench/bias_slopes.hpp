#pragma once
/// How fast the bias of every biased technique falls: the mean of an image's layer by it, less that of the unbiased technique, at several radii, and the slope in logarithms with its confidence.
/// One pass is a render, so that its radius is the one that was asked for; seeds are the replicas that confidence comes from.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/render.hpp"
#include "scene/load_scene.hpp"

namespace tyndall::bias {

/// Radii are shares of the scene's half diagonal. Of a clamp C the radius is 1 / sqrt(C): connections below it are dimmed.
struct Study {
    std::string name, scene;           ///< scene: XML
    Layer layer;
    RenderSettings biased, unbiased;   ///< without seed, radius and clamp
    bool same_numbers;                 ///< both techniques draw the same paths and places from a seed, so that most of the noise cancels
    std::vector<double> radii;
    double predicted;                  ///< the slope (kernels/README.md, sections 17 to 19)
};

/// bias[k][i]: at radius k, replica i, over the unbiased mean of all replicas.
struct Biases {
    double unbiased = 0, error = 0;    ///< mean of the layer, and its standard error
    std::vector<std::vector<double>> bias;
};

struct Slope {
    double value = 0, half_width = 0;  ///< of its 95 % confidence interval
    bool holds(double slope) const { return std::abs(slope - value) <= half_width; }
};

inline double mean(const std::vector<double>& values)
{
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

inline double standard_error(const std::vector<double>& values)
{
    const double m = mean(values), n = static_cast<double>(values.size());
    double squares = 0;
    for (const double v : values) squares += (v - m) * (v - m);
    return std::sqrt(squares / (n * (n - 1)));
}

/// Mean over pixels and channels of one pass of the layer.
inline double layer_mean(const Scene& scene, Layer layer, RenderSettings settings, std::uint64_t seed)
{
    settings.layers = LayerSet().add(layer), settings.seed = seed;
    if (settings.passes == 0) settings.passes = 1;
    double sum = 0;
    const RenderOutcome outcome = render(scene, settings);
    const std::vector<Rgb> image = outcome.film.mean(layer);
    for (const Rgb& pixel : image) sum += (pixel.r + pixel.g + pixel.b) / 3;
    return sum / static_cast<double>(image.size());
}

/// scale: what the biased technique is multiplied by; other than 1: a planted error.
inline Biases measure(const Study& study, int replicas, double scale = 1)
{
    const Scene scene = parse_scene(study.scene, ".", study.name + ".xml");
    Biases found{.bias = std::vector<std::vector<double>>(study.radii.size())};
    std::vector<double> unbiased;
    for (int i = 0; i < replicas; ++i) unbiased.push_back(layer_mean(scene, study.layer, study.unbiased, static_cast<std::uint64_t>(study.same_numbers ? i + 1 : i + 1001)));
    found.unbiased = mean(unbiased), found.error = standard_error(unbiased);
    for (std::size_t k = 0; k < study.radii.size(); ++k)
        for (int i = 0; i < replicas; ++i) {
            RenderSettings settings = study.biased;
            const double r = study.radii[k];
            const bool clamped = std::string(settings.method.name()).ends_with("-clamped");
            if (clamped) settings.clamp = 1 / (r * r);
            else settings.beam_radius = r;
            const double value = scale * layer_mean(scene, study.layer, settings, static_cast<std::uint64_t>(i + 1));
            found.bias[k].push_back((value - unbiased[static_cast<std::size_t>(i)]) / found.unbiased);
        }
    return found;
}

/// Least squares through the logarithms of the mean biases; left_out: a replica that does not count.
inline double slope_without(const Study& study, const Biases& biases, int left_out)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    const double n = static_cast<double>(study.radii.size());
    for (std::size_t k = 0; k < study.radii.size(); ++k) {
        double sum = 0;
        for (int i = 0; i < static_cast<int>(biases.bias[k].size()); ++i)
            if (i != left_out) sum += biases.bias[k][static_cast<std::size_t>(i)];
        const double lx = std::log(study.radii[k]), ly = std::log(std::abs(sum));
        x += lx, y += ly, xx += lx * lx, xy += lx * ly;
    }
    return (xy - x * y / n) / (xx - x * x / n);
}

/// With the confidence that the jackknife over replicas gives. t: Student's quantile .975 for one degree of freedom less than there are replicas.
inline Slope slope_of(const Study& study, const Biases& biases, double t)
{
    const int n = static_cast<int>(biases.bias[0].size());
    std::vector<double> parts;
    for (int i = 0; i < n; ++i) parts.push_back(slope_without(study, biases, i));
    return {slope_without(study, biases, -1), t * (n - 1) * standard_error(parts)};
}

inline constexpr int usual_replicas = 16;
inline constexpr double usual_t = 2.131;  ///< Student's, 15 degrees of freedom

/// A cube of fog, so thick that its boundary is not felt, around camera and lamp.
inline std::string deep_fog(const std::string& lamp, const std::string& looking, double fov)
{
    return R"(<scene version="3.0.0"><medium type="homogeneous" id="fog"><float name="sigma_t" value="1.5"/><float name="albedo" value=".8"/></medium>
<shape type="cube"><transform name="to_world"><scale value="3"/></transform><bsdf type="null"/><ref name="interior" id="fog"/></shape>)" + lamp + R"(
<sensor type="perspective"><float name="fov" value=")" + std::to_string(fov) + R"("/><float name="near_clip" value=".001"/><float name="far_clip" value="100"/><transform name="to_world"><lookat )" + looking + R"( up="0, 1, 0"/></transform>
<film type="hdrfilm"><integer name="width" value="12"/><integer name="height" value="12"/><rfilter type="box"/></film><ref id="fog"/></sensor></scene>)";
}

/// Floor and ceiling, a lamp between them that shines upwards: the floor is lit by the ceiling alone.
inline std::string floor_and_ceiling()
{
    const auto plate = [](const char* y, const char* half, const char* angle, const char* content) {
        return std::string("<shape type=\"rectangle\"><transform name=\"to_world\"><scale value=\"") + half + "\"/><rotate x=\"1\" angle=\"" + angle + "\"/><translate y=\"" + y + "\"/></transform>" + content + "</shape>";
    };
    return "<scene version=\"3.0.0\">" + plate("0", "2", "-90", R"(<bsdf type="diffuse"><float name="reflectance" value=".5"/></bsdf>)") + plate("1", ".5", "90", R"(<bsdf type="diffuse"><float name="reflectance" value=".8"/></bsdf>)") +
           plate(".9", ".1", "-90", R"(<bsdf type="diffuse"><float name="reflectance" value="0"/></bsdf><emitter type="area"><float name="radiance" value="10"/></emitter>)") +
           R"(<sensor type="perspective"><float name="fov" value="10"/><transform name="to_world"><lookat origin="1.6, 1, 0" target="0, 0, 0" up="0, 1, 0"/></transform>
<film type="hdrfilm"><integer name="width" value="16"/><integer name="height" value="16"/><rfilter type="box"/></film></sensor></scene>)";
}

inline std::vector<Study> studies()
{
    const std::string lamp = R"(<emitter type="point"><point name="position" x="0" y=".9" z="0"/><float name="intensity" value="1"/><ref id="fog"/></emitter>)";
    const std::string beside = deep_fog(lamp, R"(origin="0, 0, 1.2" target="0, 0, 0")", 20);
    return {
        {"clamped point lights", beside, Layer::media_to_media, {.method = Method("vpl-clamped"), .lights = 8192, .selection = Selection::all}, {.method = Method("vpl"), .lights = 8192, .selection = Selection::all}, true,
         {.004, .008, .016, .032}, 1},
        {"virtual beam lights", beside, Layer::media_to_media, {.method = Method("vbl"), .lights = 32768, .selection = Selection::all}, {.method = Method::vrl, .lights = 32768, .selection = Selection::all}, true,
         {.02, .028, .04, .055}, 2},
        {"photon beams", beside, Layer::single, {.method = Method("beams"), .lights = 1u << 16}, {.method = Method::vrl, .passes = 64}, false, {.025, .035, .05, .07}, 2},
        {"photons", floor_and_ceiling(), Layer::surface_indirect, {.method = Method("photons"), .lights = 1u << 17}, {.method = Method("vpl"), .passes = 64, .lights = 1024, .selection = Selection::all}, false, {.06, .085, .12, .17}, 2},
    };
}

}  // namespace tyndall::bias

#include "scene/describe.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

#include "scene/phases.hpp"
#include "scene/render_space.hpp"
#include "scene/text.hpp"
#include "scene/volume_values.hpp"

namespace tyndall {

namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// 0.6, or 0.15 0.4 1 if the channels differ.
std::string words(const Vec3& v)
{
    return v.x == v.y && v.y == v.z ? fmt::format("{:.6g}", v.x) : fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}
std::string point_words(const Vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }

std::string medium_name(const Scene& scene, int medium)
{
    return medium == vacuum ? "vacuum" : in_quotes(scene.media[static_cast<std::size_t>(medium)].name);
}

const char* type_name(Shape::Type type)
{
    constexpr std::array names{"mesh", "sphere", "disk", "cylinder"};
    return names[static_cast<std::size_t>(type)];
}

/// Intensity back in the file's units.
Rgb file_value(const Scene& scene, const Emitter& emitter)
{
    const bool by_distance = emitter.type == Emitter::Type::point || emitter.type == Emitter::Type::spot;
    return by_distance ? emitter.value * scene.unit * scene.unit : emitter.value;
}

double diagonal(const Scene& scene) { return 2 * bounds_of(scene).radius(); }

std::string camera_words(const Scene& scene)
{
    const Camera& camera = scene.camera;
    std::string text = fmt::format("camera     at {}, {:.6g} degrees wide, clips {:.6g} to {:.6g}, in {}\n",
                                   point_words(to_file_space(scene, Vec3(camera.to_world[3]))), degrees(camera.fov_x),
                                   camera.near_clip * scene.unit, camera.far_clip * scene.unit, medium_name(scene, camera.medium));
    text += fmt::format("film       {} x {} pixels", camera.width, camera.height);
    if (camera.crop_width != camera.width || camera.crop_height != camera.height)
        text += fmt::format(", cropped to {} x {} at ({}, {})", camera.crop_width, camera.crop_height, camera.crop_x, camera.crop_y);
    text += camera.filter.type == Filter::Type::box ? ", box filter\n"
                                                    : fmt::format(", gaussian filter of {:.6g} pixels\n", camera.filter.stddev);
    return text;
}

std::string varying_medium_words(const Scene& scene, const Medium& medium, const std::string& phase)
{
    const auto grid_name = [&](int volume) { return in_quotes(scene.volumes[static_cast<std::size_t>(volume)].name); };
    const Rgb largest = largest_extinction(scene, medium);
    const double across = medium.density == none ? diagonal(scene) : 2 * bounds_of(scene.volumes[static_cast<std::size_t>(medium.density)]).radius();
    const std::string sigma_t = medium.density == none ? words(medium.sigma_t / scene.unit) : fmt::format("{} x {}, at most {}", words(medium.sigma_t / scene.unit), grid_name(medium.density), words(largest / scene.unit));
    const std::string albedo = medium.albedo_volume == none ? words(medium.albedo) : fmt::format("{}, at most {}", grid_name(medium.albedo_volume), words(medium.albedo));
    return fmt::format("medium     {}: sigma_t {}; albedo {}; {}; optical thickness across its box at most {}\n", in_quotes(medium.name), sigma_t, albedo, phase, words(largest * across));
}

std::string medium_words(const Scene& scene, const Medium& medium)
{
    if (!medium.homogeneous()) return varying_medium_words(scene, medium, phase_words(medium.phase));
    return fmt::format("medium     {}: sigma_t {}, albedo {}, {}; optical thickness across the scene {}\n", in_quotes(medium.name),
                       words(medium.sigma_t / scene.unit), words(medium.albedo), phase_words(medium.phase), words(medium.sigma_t * diagonal(scene)));
}

std::string volume_words(const Scene& scene, const Volume& volume)
{
    const VolumeStatistics statistics = statistics_of(volume);
    const Bounds box = bounds_of(volume);
    return fmt::format("volume     {}: {} x {} x {} voxels of {}, values {} to {}, mean {}, {:.2f} MiB, from {} to {}\n", in_quotes(volume.name), volume.size_x, volume.size_y, volume.size_z,
                       volume.channels == 1 ? "one channel" : "3 channels", words(statistics.least), words(statistics.largest), words(statistics.mean),
                       static_cast<double>(statistics.bytes) / (1 << 20), point_words(to_file_space(scene, box.low)), point_words(to_file_space(scene, box.high)));
}

std::string shape_words(const Scene& scene, const Shape& shape)
{
    std::string text = fmt::format("shape      {}: ", in_quotes(shape.name));
    if (shape.type == Shape::Type::mesh)
        text += fmt::format("{} triangles, {}", shape.mesh.triangles.size(),
                            !shape.mesh.closed  ? "open"
                            : shape.mesh.convex ? "closed, convex"
                                                : "closed, not convex");
    else
        text += type_name(shape.type);
    text += fmt::format(", {}", type_name(scene.bsdfs[static_cast<std::size_t>(shape.bsdf)].type));
    if (shape.flip_normals) text += ", normals flipped";
    if (shape.emitter != none) text += ", glows";
    if (shape.medium_boundary)
        text += fmt::format(", {} inside and {} outside", medium_name(scene, shape.interior), medium_name(scene, shape.exterior));
    return text + "\n";
}

std::string emitter_words(const Scene& scene, const Emitter& emitter)
{
    std::string text =
        fmt::format("emitter    {}: {} {}", in_quotes(emitter.name), type_name(emitter.type), words(file_value(scene, emitter)));
    if (emitter.type == Emitter::Type::point || emitter.type == Emitter::Type::spot)
        text += " at " + point_words(to_file_space(scene, emitter.position));
    if (emitter.type == Emitter::Type::spot)
        text += fmt::format(", {:.6g} degrees with full light within {:.6g}", degrees(emitter.cutoff), degrees(emitter.beam));
    if (emitter.type == Emitter::Type::spot || emitter.type == Emitter::Type::directional)
        text += " towards " + point_words(emitter.direction);
    if (emitter.map != none) {
        const EnvironmentMap& map = scene.environment_maps[static_cast<std::size_t>(emitter.map)];
        text += fmt::format(" x {} of {} x {} pixels, mean radiance {}", in_quotes(map.name), map.width, map.height, words(map.mean * emitter.value));
    }
    if (emitter.shape != none) text += " on shape " + in_quotes(scene.shapes[static_cast<std::size_t>(emitter.shape)].name);
    return text + (emitter.medium == vacuum ? "" : ", in " + medium_name(scene, emitter.medium)) + "\n";
}

/// Ends the line.
std::string roughness_words(const Bsdf& bsdf)
{
    const Roughness& r = bsdf.roughness;
    if (bsdf.type != Bsdf::Type::rough_dielectric && bsdf.type != Bsdf::Type::rough_conductor && bsdf.type != Bsdf::Type::rough_plastic) return "\n";
    const std::string alpha = r.alpha_u == r.alpha_v ? fmt::format("{:.6g}", r.alpha_u) : fmt::format("{:.6g} along u, {:.6g} along v", r.alpha_u, r.alpha_v);
    return fmt::format(", {} facets of roughness {}\n", r.type == Roughness::Type::ggx ? "GGX" : "Beckmann", alpha);
}

/// The colour, or the texture's name.
std::string colour_words(const Scene& scene, const Rgb& colour, int texture)
{
    return texture == none ? words(colour) : in_quotes(scene.textures[static_cast<std::size_t>(texture)].name);
}

std::string bsdf_words(const Scene& scene, const Bsdf& bsdf)
{
    std::string text =
        fmt::format("bsdf       {}: {}{}", in_quotes(bsdf.name), type_name(bsdf.type), bsdf.two_sided ? ", on both sides" : "");
    if (bsdf.type != Bsdf::Type::null) text += " reflectance " + colour_words(scene, bsdf.reflectance, bsdf.reflectance_texture);
    using Type = Bsdf::Type;
    const Type type = bsdf.type;
    const bool plastic = type == Type::plastic || type == Type::rough_plastic, conductor = type == Type::conductor || type == Type::rough_conductor;
    if (type == Type::dielectric || type == Type::thin_dielectric || type == Type::rough_dielectric)
        text += fmt::format(", transmittance {}, relative index {:.6g}", colour_words(scene, bsdf.specular_transmittance, bsdf.transmittance_texture), bsdf.eta);
    if (plastic) text += fmt::format(", below it {}, relative index {:.6g}", colour_words(scene, bsdf.diffuse, bsdf.diffuse_texture), bsdf.eta);
    if (conductor) text += fmt::format(", eta {}, k {}", words(bsdf.conductor_eta), words(bsdf.conductor_k));
    return text + roughness_words(bsdf);
}

std::string texture_words(const Texture& texture)
{
    const std::string name = in_quotes(texture.name);
    if (texture.type == Texture::Type::checkerboard) return fmt::format("texture    {}: checkerboard of {} and {}\n", name, words(texture.even), words(texture.odd));
    return fmt::format("texture    {}: bitmap of {} x {} pixels, {}, at most {}\n", name, texture.width, texture.height, texture.channels == 1 ? "grey" : "coloured", words(texture.largest));
}

}  // namespace

const char* type_name(Bsdf::Type type)
{
    constexpr std::array names{"null", "diffuse", "dielectric", "conductor", "thindielectric", "roughdielectric", "roughconductor", "plastic", "roughplastic"};
    return names[static_cast<std::size_t>(type)];
}

const char* type_name(Emitter::Type type)
{
    constexpr std::array names{"point", "spot", "area", "directional", "constant", "envmap"};
    return names[static_cast<std::size_t>(type)];
}

std::string describe(const Scene& scene)
{
    const Bounds bounds = bounds_of(scene);
    std::size_t triangles = 0;
    for (const Shape& shape : scene.shapes) triangles += shape.mesh.triangles.size();
    std::string text = fmt::format("scene      {}, hash {:016x}\n", in_quotes(scene.file), scene.hash);
    text += fmt::format("bounds     {} to {}, {} shapes with {} triangles; one render-space unit is {:g}\n",
                        point_words(to_file_space(scene, bounds.low)), point_words(to_file_space(scene, bounds.high)), scene.shapes.size(),
                        triangles, scene.unit);
    text += camera_words(scene);
    text += fmt::format("integrator {}, max_depth {}\n", scene.integrator.empty() ? "(none named)" : in_quotes(scene.integrator),
                        scene.max_depth);
    for (const Medium& medium : scene.media) text += medium_words(scene, medium);
    for (const Volume& volume : scene.volumes) text += volume_words(scene, volume);
    for (const Shape& shape : scene.shapes) text += shape_words(scene, shape);
    for (const Emitter& emitter : scene.emitters) text += emitter_words(scene, emitter);
    for (const Bsdf& bsdf : scene.bsdfs) text += bsdf_words(scene, bsdf);
    for (const Texture& texture : scene.textures) text += texture_words(texture);
    for (const std::string& warning : scene.warnings) text += "warning    " + warning + "\n";
    return text;
}

}  // namespace tyndall

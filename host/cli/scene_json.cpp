#include "cli/scene_json.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "scene/describe.hpp"
#include "scene/render_space.hpp"
#include "scene/volume_values.hpp"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Name of a medium or null for vacuum.
Json medium_name(const Scene& scene, int medium)
{
    return medium == vacuum ? Json(nullptr) : Json(scene.media[static_cast<std::size_t>(medium)].name);
}

/// Named as in the scene file; a table tells how many values it has, a blend its parts.
Json phase_of(const PhaseFunction& phase)
{
    constexpr std::array types{"isotropic", "hg", "rayleigh", "tabphase", "blendphase"};
    Json json{{"phase", types[static_cast<std::size_t>(phase.type)]}, {"g", phase.g}};
    if (phase.type == PhaseFunction::Type::table) json["values"] = phase.values.size();
    for (const PhaseFunction& part : phase.parts) {
        json["parts"].push_back({{"weight", part.weight}});
        json["parts"].back().update(phase_of(part));
    }
    return json;
}

/// Number of a volume or texture in its list, or null.
Json number_or_null(int index) { return index == none ? Json(nullptr) : Json(index); }

Json volumes_of(const Scene& scene)
{
    Json volumes = Json::array();
    for (const auto& volume : scene.volumes) {
        const VolumeStatistics statistics = statistics_of(volume);
        const Bounds box = bounds_of(volume);
        volumes.push_back({{"name", volume.name},
                           {"where", to_string(volume.where)},
                           {"size", {volume.size_x, volume.size_y, volume.size_z}},
                           {"channels", volume.channels},
                           {"least", json_of(statistics.least)},
                           {"mean", json_of(statistics.mean)},
                           {"largest", json_of(statistics.largest)},
                           {"bytes", statistics.bytes},
                           {"low", json_of(to_file_space(scene, box.low))},
                           {"high", json_of(to_file_space(scene, box.high))}});
    }
    return volumes;
}

Json media_of(const Scene& scene)
{
    Json media = Json::array();
    for (const auto& medium : scene.media) {
        media.push_back({{"name", medium.name},
                         {"where", to_string(medium.where)},
                         {"sigma_t", json_of(medium.sigma_t / scene.unit)},
                         {"density", number_or_null(medium.density)},
                         {"albedo", json_of(medium.albedo)},
                         {"albedo_volume", number_or_null(medium.albedo_volume)}});
        media.back().update(phase_of(medium.phase));
    }
    return media;
}

Json shapes_of(const Scene& scene)
{
    constexpr std::array types{"mesh", "sphere", "disk", "cylinder"};
    Json shapes = Json::array();
    for (const auto& shape : scene.shapes) {
        Json json{{"name", shape.name}, {"where", to_string(shape.where)}, {"type", types[static_cast<std::size_t>(shape.type)]}};
        if (shape.type == Shape::Type::mesh)
            json["triangles"] = shape.mesh.triangles.size(), json["closed"] = shape.mesh.closed, json["convex"] = shape.mesh.convex;
        json["bsdf"] = scene.bsdfs[static_cast<std::size_t>(shape.bsdf)].name;
        json["emitter"] = shape.emitter == none ? Json(nullptr) : Json(scene.emitters[static_cast<std::size_t>(shape.emitter)].name);
        if (shape.medium_boundary)
            json["interior"] = medium_name(scene, shape.interior), json["exterior"] = medium_name(scene, shape.exterior);
        shapes.push_back(json);
    }
    return shapes;
}

Json emitters_of(const Scene& scene)
{
    Json emitters = Json::array();
    for (const auto& emitter : scene.emitters)
        emitters.push_back({{"name", emitter.name},
                            {"where", to_string(emitter.where)},
                            {"type", type_name(emitter.type)},
                            {"map", number_or_null(emitter.map)},
                            {"medium", medium_name(scene, emitter.medium)}});
    return emitters;
}

Json bsdfs_of(const Scene& scene)
{
    Json bsdfs = Json::array();
    for (const auto& bsdf : scene.bsdfs)
        bsdfs.push_back({{"name", bsdf.name},
                         {"where", to_string(bsdf.where)},
                         {"type", type_name(bsdf.type)},
                         {"two_sided", bsdf.two_sided},
                         {"reflectance_texture", number_or_null(bsdf.reflectance_texture)},
                         {"transmittance_texture", number_or_null(bsdf.transmittance_texture)},
                         {"diffuse_texture", number_or_null(bsdf.diffuse_texture)}});
    return bsdfs;
}

Json textures_of(const Scene& scene)
{
    Json textures = Json::array();
    for (const auto& texture : scene.textures) {
        const bool bitmap = texture.type == Texture::Type::bitmap;
        textures.push_back({{"name", texture.name}, {"where", to_string(texture.where)}, {"type", bitmap ? "bitmap" : "checkerboard"}, {"largest", json_of(texture.largest)}});
        if (bitmap) textures.back().update({{"width", texture.width}, {"height", texture.height}, {"channels", texture.channels}});
    }
    return textures;
}

Json film_of(const Camera& camera)
{
    return {{"width", camera.width},
            {"height", camera.height},
            {"crop", {camera.crop_x, camera.crop_y, camera.crop_width, camera.crop_height}},
            {"filter", camera.filter.type == Filter::Type::box ? "box" : "gaussian"}};
}

}  // namespace

std::string to_json(const Scene& scene)
{
    Json json;
    json["schema"] = "tyndall-scene/1";
    json["file"] = scene.file;
    json["hash"] = fmt::format("{:016x}", scene.hash);
    json["integrator"] = scene.integrator;
    json["max_depth"] = scene.max_depth < 0 ? Json(nullptr) : Json(scene.max_depth);
    json["film"] = film_of(scene.camera);
    json["camera_medium"] = medium_name(scene, scene.camera.medium);
    json["media"] = media_of(scene);
    json["volumes"] = volumes_of(scene);
    json["bsdfs"] = bsdfs_of(scene);
    json["textures"] = textures_of(scene);
    json["environment_maps"] = Json::array();
    for (const auto& map : scene.environment_maps)
        json["environment_maps"].push_back({{"name", map.name}, {"where", to_string(map.where)}, {"width", map.width}, {"height", map.height}, {"mean", json_of(map.mean)}});
    json["shapes"] = shapes_of(scene);
    json["emitters"] = emitters_of(scene);
    json["warnings"] = scene.warnings;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tyndall

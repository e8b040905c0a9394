#include "library/scene_from_description.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "library/checked_values.hpp"
#include "library/description_hash.hpp"
#include "library/pictures_from_description.hpp"
#include "scene/mesh_geometry.hpp"
#include "scene/phases.hpp"
#include "scene/plastic.hpp"
#include "scene/render_space.hpp"
#include "scene/scene_warnings.hpp"
#include "scene/transforms.hpp"

namespace tyndall {
namespace {

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

PhaseFunction phase_of(const api::Phase& phase, const Place& place)
{
    switch (phase.type) {
        case api::Phase::Type::isotropic: return {};
        case api::Phase::Type::henyey_greenstein: return henyey_greenstein_phase(place.number("g", phase.g, -1, 1, true));
        case api::Phase::Type::rayleigh: return rayleigh_phase();
        case api::Phase::Type::table: break;
    }
    double total = 0;
    for (const double value : phase.values) total += place.number("a value of the table", value, 0, 1e300);
    place.require(phase.values.size() >= 2 && total > 0, "a table takes two or more values, not all of them 0");
    return table_phase(phase.values);
}

/// Adds the voxels; returns their index.
int add_grid(const api::Grid& grid, const Place& place, Scene& scene)
{
    const auto [x, y, z] = grid.size;
    place.require(x > 0 && y > 0 && z > 0 && x <= 1 << 15 && y <= 1 << 15 && z <= 1 << 15, "a grid has between 1 and 32768 voxels along every axis");
    place.require(grid.values.size() == std::size_t(x) * std::size_t(y) * std::size_t(z), fmt::format("a grid of {} x {} x {} voxels has {} values", x, y, z, grid.values.size()));
    for (const float value : grid.values) place.require(std::isfinite(value) && value >= 0, "the values of a grid must be finite and not negative");
    const Vec3 low = place.point("low", grid.low), high = place.point("high", grid.high);
    place.require(low.x < high.x && low.y < high.y && low.z < high.z, "the corner low of a grid must lie below high along every axis");
    scene.volumes.push_back({.name = place.name(), .size_x = x, .size_y = y, .size_z = z, .channels = 1, .values = grid.values, .to_world = translation(low) * scaling(high - low)});
    return static_cast<int>(scene.volumes.size()) - 1;
}

Bsdf::Type type_of(api::Bsdf::Type type)
{
    using From = api::Bsdf::Type;
    switch (type) {
        case From::null: return Bsdf::Type::null;
        case From::diffuse: return Bsdf::Type::diffuse;
        case From::dielectric: return Bsdf::Type::dielectric;
        case From::conductor: return Bsdf::Type::conductor;
        case From::thin_dielectric: return Bsdf::Type::thin_dielectric;
        case From::rough_dielectric: return Bsdf::Type::rough_dielectric;
        case From::rough_conductor: return Bsdf::Type::rough_conductor;
        case From::plastic: return Bsdf::Type::plastic;
        case From::rough_plastic: return Bsdf::Type::rough_plastic;
    }
    throw SceneError("a bsdf of an unknown type");
}

/// The index of a texture, whose largest values take the place of `colour`; none if there is none.
int textured(const char* what, std::optional<int> index, Rgb& colour, const Place& place, const Scene& scene)
{
    if (!index) return none;
    colour = scene.textures[static_cast<std::size_t>(place.index(what, *index, scene.textures.size(), 0))].largest;
    return *index;
}

void add_bsdf(const api::Bsdf& from, const Place& place, Scene& scene)
{
    Bsdf bsdf{.name = from.name, .type = type_of(from.type)};
    using Type = Bsdf::Type;
    const bool glass = bsdf.type == Type::dielectric || bsdf.type == Type::thin_dielectric || bsdf.type == Type::rough_dielectric;
    bsdf.reflectance = bsdf.type == Type::null ? Rgb(0) : place.colour("reflectance", from.reflectance, 1);
    bsdf.specular_transmittance = place.colour("transmittance", from.transmittance, 1);
    const bool plastic = bsdf.type == Type::plastic || bsdf.type == Type::rough_plastic;
    if (glass || plastic) bsdf.eta = place.number("eta", from.eta, .01, 100, true);  // no material comes near these ends
    place.require((bsdf.type != Type::rough_dielectric && !plastic) || std::abs(bsdf.eta - 1) >= 1e-6, "eta = 1 makes no boundary; use the type null, or dielectric");
    bsdf.conductor_eta = place.colour("conductor_eta", from.conductor_eta, 1e300), bsdf.conductor_k = place.colour("conductor_k", from.conductor_k, 1e300);
    const double alpha = place.number("alpha", from.alpha, 1e-4, 10);
    bsdf.roughness = {.type = from.ggx ? Roughness::Type::ggx : Roughness::Type::beckmann, .alpha_u = alpha, .alpha_v = alpha};
    bsdf.two_sided = from.two_sided;
    if (bsdf.type != Type::null) bsdf.reflectance_texture = textured("reflectance_texture", from.reflectance_texture, bsdf.reflectance, place, scene);
    if (glass) bsdf.transmittance_texture = textured("transmittance_texture", from.transmittance_texture, bsdf.specular_transmittance, place, scene);
    if (plastic) {
        bsdf.diffuse = place.colour("below", from.below, 1), bsdf.nonlinear = from.nonlinear;
        bsdf.diffuse_texture = textured("below_texture", from.below_texture, bsdf.diffuse, place, scene);
        prepare_plastic(bsdf);
    }
    place.require(!bsdf.two_sided || (!glass && bsdf.type != Type::null), "only what lets no light through can be two-sided");
    scene.bsdfs.push_back(std::move(bsdf));
}

Mesh triangles_of(const api::Mesh& from, const Place& place)
{
    Mesh mesh;
    for (const api::Triple& vertex : from.vertices) mesh.vertices.push_back(place.point("a vertex", vertex));
    for (const api::Triple& normal : from.normals) mesh.normals.push_back(place.direction("a normal", normal));
    place.require(from.normals.empty() || from.normals.size() == from.vertices.size(), fmt::format("{} normals for {} vertices; give one each, or none", from.normals.size(), from.vertices.size()));
    place.require(from.uvs.empty() || from.uvs.size() == from.vertices.size(), fmt::format("{} texture coordinates for {} vertices; give one each, or none", from.uvs.size(), from.vertices.size()));
    const auto coordinate = [&](double x) { return place.number("a texture coordinate", x, -largest_coordinate, largest_coordinate); };
    for (const auto& [u, v] : from.uvs) mesh.uvs.emplace_back(coordinate(u), coordinate(v));
    for (const auto& [a, b, c] : from.triangles) {
        place.require(a < from.vertices.size() && b < from.vertices.size() && c < from.vertices.size(),
                      fmt::format("triangle {} has a corner beyond the {} vertices", mesh.triangles.size(), from.vertices.size()));
        mesh.triangles.emplace_back(a, b, c);
    }
    classify_mesh(mesh);
    place.require(!mesh.triangles.empty(), "no triangle of it has an area");
    return mesh;
}

void add_mesh(const api::Mesh& from, const Place& place, Scene& scene)
{
    Shape shape{.name = from.name, .type = Shape::Type::mesh, .mesh = triangles_of(from, place)};
    shape.bsdf = place.index("bsdf", from.bsdf, scene.bsdfs.size(), 0);
    shape.medium_boundary = from.interior || from.exterior;
    shape.interior = place.index("interior", from.interior.value_or(vacuum), scene.media.size(), vacuum);
    shape.exterior = place.index("exterior", from.exterior.value_or(vacuum), scene.media.size(), vacuum);
    const Bsdf& bsdf = scene.bsdfs[static_cast<std::size_t>(shape.bsdf)];
    if (shape.mesh.uvs.empty() && (bsdf.reflectance_texture != none || bsdf.transmittance_texture != none || bsdf.diffuse_texture != none))
        scene.warnings.push_back(place.name() + ": has no texture coordinates, so that every triangle shows half of the unit square of its texture; hand over uvs");
    if (from.radiance) {
        place.require(bsdf.type != Bsdf::Type::null, "glows, but its bsdf is null: light cannot leave a surface that is not there");
        shape.emitter = static_cast<int>(scene.emitters.size());
        scene.emitters.push_back({.name = from.name, .type = Emitter::Type::area, .value = place.colour("radiance", *from.radiance, 1e300), .shape = static_cast<int>(scene.shapes.size()),
                                  .medium = shape.medium_boundary ? shape.exterior : vacuum});
    }
    scene.shapes.push_back(std::move(shape));
}

void add_emitter(const api::Emitter& from, const Place& place, Scene& scene)
{
    using From = api::Emitter::Type;
    Emitter emitter{.name = from.name, .type = Emitter::Type::constant, .value = place.colour("value", from.value, 1e300)};
    if (from.type == From::point) emitter.type = Emitter::Type::point;
    if (from.type == From::spot) emitter.type = Emitter::Type::spot;
    if (from.type == From::directional) emitter.type = Emitter::Type::directional;
    if (from.type == From::environment) {
        emitter.type = Emitter::Type::envmap, emitter.map_to_world = turning_of(from, place);
        emitter.map = place.index("map", from.map, scene.environment_maps.size(), 0);
    }
    emitter.position = place.point("position", from.position);
    if (from.type == From::spot || from.type == From::directional) emitter.direction = place.direction("direction", from.direction);
    emitter.cutoff = radians(place.number("cutoff_degrees", from.cutoff_degrees, 0, 180, true));
    emitter.beam = radians(place.number("beam_degrees", from.beam_degrees, 0, from.cutoff_degrees));
    emitter.medium = place.index("medium", from.medium, scene.media.size(), vacuum);
    scene.emitters.push_back(std::move(emitter));
}

Camera camera_of(const api::Camera& from, const Place& place, const Scene& scene)
{
    Camera camera{.fov_x = radians(place.number("fov_degrees", from.fov_degrees, 0, 180, true))};
    camera.to_world = look_at(place.point("origin", from.origin), place.point("target", from.target), place.point("up", from.up), {.file = place.name()});
    camera.near_clip = place.number("near_clip", from.near_clip, 0, 1e300, true), camera.far_clip = place.number("far_clip", from.far_clip, 0, 1e300, true);
    place.require(camera.near_clip < camera.far_clip, "near_clip must be less than far_clip");
    place.require(from.width >= 1 && from.height >= 1 && from.width <= 65536 && from.height <= 65536, fmt::format("a film of {} x {} pixels; each side has 1 to 65536", from.width, from.height));
    camera.width = camera.crop_width = from.width, camera.height = camera.crop_height = from.height;
    if (from.box_filter) camera.filter.type = Filter::Type::box;
    camera.medium = place.index("medium", from.medium, scene.media.size(), vacuum);
    return camera;
}

template <typename Element, typename Add>
void add_all(const api::SceneDescription& from, const char* kind, const std::vector<Element>& elements, Scene& scene, Add&& add)
{
    for (std::size_t i = 0; i < elements.size(); ++i) add(elements[i], Place(from.name, fmt::format("{} {} \"{}\"", kind, i, elements[i].name)), scene);
}

/// What the loader would say. Its readers' state is asked for, so an empty document stands in.
void warn(Scene& scene)
{
    SceneFiles files(".", false);
    const SceneDocument document(parse_xml("<scene version=\"3.0.0\"/>", scene.file), files, {});
    SceneBuilder builder{.document = document, .files = files, .scene = std::move(scene)};
    add_warnings(builder);
    scene = std::move(builder.scene);
}

}  // namespace

void add_medium(const api::Medium& from, const Place& place, Scene& scene)
{
    Medium medium{.name = from.name, .sigma_t = place.colour("sigma_t", from.sigma_t, 1e300), .albedo = place.colour("albedo", from.albedo, 1), .phase = phase_of(from.phase, place)};
    if (from.density) medium.density = add_grid(*from.density, place, scene);
    scene.media.push_back(std::move(medium));
}

Scene scene_from(const api::SceneDescription& from)
{
    Scene scene{.file = from.name, .hash = hash_of(from)};
    add_all(from, "medium", from.media, scene, add_medium);
    add_all(from, "texture", from.textures, scene, add_texture);
    add_all(from, "environment map", from.environment_maps, scene, add_environment_map);
    add_all(from, "bsdf", from.bsdfs, scene, add_bsdf);
    add_all(from, "mesh", from.meshes, scene, add_mesh);
    add_all(from, "emitter", from.emitters, scene, add_emitter);
    const Place camera(from.name, "camera");
    scene.camera = camera_of(from.camera, camera, scene);
    camera.require(from.max_depth >= -1, fmt::format("max_depth = {} must be -1 (no limit) or at least 0", from.max_depth));
    scene.max_depth = from.max_depth;
    to_render_space(scene);
    warn(scene);
    return scene;
}

}  // namespace tyndall

/// The C interface: scenes.
#include <string>

#include "library/c_description.hpp"

using namespace tyndall;

extern "C" {

tyndall_status tyndall_scene_load(const char* file, tyndall_scene** scene)
{
    return made(scene, [&] { return new tyndall_scene{api::Scene::load(&needed(file, "the file's name"))}; });
}

tyndall_status tyndall_scene_load_with(const char* file, const char* const* names, const char* const* values, size_t count, int allow_outside, tyndall_scene** scene)
{
    return made(scene, [&] {
        api::LoadOptions options{.allow_outside = allow_outside != 0};
        for (std::size_t i = 0; i < count; ++i)
            options.definitions.insert_or_assign(&needed((&needed(names, "names"))[i], "a name"), &needed((&needed(values, "values"))[i], "a value"));
        return new tyndall_scene{api::Scene::load(&needed(file, "the file's name"), options)};
    });
}

tyndall_status tyndall_scene_with_film(const tyndall_scene* scene, int width, int height, tyndall_scene** other)
{
    return made(other, [&] { return new tyndall_scene{needed(scene, "the scene").scene.with_film(width, height)}; });
}

tyndall_status tyndall_scene_parse(const char* xml, const char* folder, const char* name, tyndall_scene** scene)
{
    return made(scene, [&] { return new tyndall_scene{api::Scene::parse(&needed(xml, "the text"), &needed(folder, "the folder"), &needed(name, "the name"))}; });
}

tyndall_status tyndall_scene_create(const tyndall_description* description, tyndall_scene** scene)
{
    return made(scene, [&] { return new tyndall_scene{api::Scene(needed(description, "the description").data)}; });
}

void tyndall_scene_destroy(tyndall_scene* scene) { delete scene; }
int tyndall_scene_width(const tyndall_scene* scene) { return scene ? scene->scene.width() : 0; }
int tyndall_scene_height(const tyndall_scene* scene) { return scene ? scene->scene.height() : 0; }

const char* tyndall_scene_warning(const tyndall_scene* scene, int index)
{
    if (!scene || index < 0 || index >= static_cast<int>(scene->scene.warnings().size())) return nullptr;
    return scene->scene.warnings()[static_cast<std::size_t>(index)].c_str();
}

tyndall_status tyndall_description_create(tyndall_description** description)
{
    return made(description, [] { return new tyndall_description; });
}

void tyndall_description_destroy(tyndall_description* description) { delete description; }

tyndall_status tyndall_add_medium(tyndall_description* description, const double* sigma_t, const double* albedo, double g, int* index)
{
    return guarded([&] {
        using Type = api::Phase::Type;
        api::Medium medium{.sigma_t = triple(sigma_t, "sigma_t"), .albedo = triple(albedo, "albedo"), .phase = {.type = g == 0 ? Type::isotropic : Type::henyey_greenstein, .g = g}};
        add(data(description).media, std::move(medium), index);
    });
}

tyndall_status tyndall_set_rayleigh(tyndall_description* description, int medium)
{
    return guarded([&] { added(data(description).media, medium, "medium").phase = {.type = api::Phase::Type::rayleigh}; });
}

tyndall_status tyndall_set_phase_table(tyndall_description* description, int medium, const double* values, size_t count)
{
    return guarded([&] { added(data(description).media, medium, "medium").phase = {.type = api::Phase::Type::table, .values = std::vector<double>(&needed(values, "values"), values + count)}; });
}

tyndall_status tyndall_set_density(tyndall_description* description, int medium, int x, int y, int z, const float* values, const double* low, const double* high)
{
    return guarded([&] {
        api::Medium& of = added(data(description).media, medium, "medium");
        if (x < 1 || y < 1 || z < 1) throw UsageError("a grid has at least one voxel along every axis");
        const std::size_t count = std::size_t(x) * std::size_t(y) * std::size_t(z);
        of.density = api::Grid{.size = {x, y, z}, .values = std::vector<float>(&needed(values, "values"), values + count), .low = triple(low, "low"), .high = triple(high, "high")};
    });
}

tyndall_status tyndall_add_null(tyndall_description* description, int* index)
{
    return guarded([&] { add(data(description).bsdfs, api::Bsdf{.type = api::Bsdf::Type::null}, index); });
}

tyndall_status tyndall_add_diffuse(tyndall_description* description, const double* reflectance, int two_sided, int* index)
{
    return guarded([&] { add(data(description).bsdfs, api::Bsdf{.reflectance = triple(reflectance, "reflectance"), .two_sided = two_sided != 0}, index); });
}

tyndall_status tyndall_add_dielectric(tyndall_description* description, double eta, double alpha, int* index)
{
    return guarded([&] {
        api::Bsdf bsdf{.type = alpha == 0 ? api::Bsdf::Type::dielectric : api::Bsdf::Type::rough_dielectric, .reflectance = {1, 1, 1}, .eta = eta};
        if (alpha != 0) bsdf.alpha = alpha;
        add(data(description).bsdfs, std::move(bsdf), index);
    });
}

tyndall_status tyndall_add_conductor(tyndall_description* description, const double* eta, const double* k, double alpha, int* index)
{
    return guarded([&] {
        api::Bsdf bsdf{.type = alpha == 0 ? api::Bsdf::Type::conductor : api::Bsdf::Type::rough_conductor, .reflectance = {1, 1, 1}, .conductor_eta = triple(eta, "eta"), .conductor_k = triple(k, "k")};
        if (alpha != 0) bsdf.alpha = alpha;
        add(data(description).bsdfs, std::move(bsdf), index);
    });
}

tyndall_status tyndall_add_plastic(tyndall_description* description, const double* below, double eta, double alpha, int two_sided, int* index)
{
    return guarded([&] {
        api::Bsdf bsdf{.type = alpha == 0 ? api::Bsdf::Type::plastic : api::Bsdf::Type::rough_plastic, .reflectance = {1, 1, 1}, .eta = eta, .two_sided = two_sided != 0, .below = triple(below, "below")};
        if (alpha != 0) bsdf.alpha = alpha;
        add(data(description).bsdfs, std::move(bsdf), index);
    });
}

tyndall_status tyndall_add_mesh(tyndall_description* description, const double* vertices, size_t vertex_count, const uint32_t* triangles, size_t triangle_count, int bsdf, int interior,
                                int exterior, const double* radiance, int* index)
{
    return guarded([&] {
        needed(vertices, "vertices"), needed(triangles, "triangles");
        api::Mesh mesh{.bsdf = bsdf, .interior = side(interior), .exterior = side(exterior)};
        for (std::size_t i = 0; i < vertex_count; ++i) mesh.vertices.push_back(triple(vertices + 3 * i, "vertices"));
        for (std::size_t i = 0; i < triangle_count; ++i) mesh.triangles.push_back({triangles[3 * i], triangles[3 * i + 1], triangles[3 * i + 2]});
        if (radiance) mesh.radiance = triple(radiance, "radiance");
        add(data(description).meshes, std::move(mesh), index);
    });
}

tyndall_status tyndall_set_normals(tyndall_description* description, int mesh, const double* normals, size_t count)
{
    return guarded([&] {
        api::Mesh& of = added(data(description).meshes, mesh, "mesh");
        needed(normals, "normals"), of.normals.clear();
        for (std::size_t i = 0; i < count; ++i) of.normals.push_back(triple(normals + 3 * i, "normals"));
    });
}

tyndall_status tyndall_add_point(tyndall_description* description, const double* intensity, const double* position, int medium)
{
    return guarded([&] {
        data(description).emitters.push_back({.value = triple(intensity, "intensity"), .position = triple(position, "position"), .medium = medium});
    });
}

tyndall_status tyndall_add_spot(tyndall_description* description, const double* intensity, const double* position, const double* direction, double cutoff_degrees, double beam_degrees, int medium)
{
    return guarded([&] {
        data(description).emitters.push_back({.type = api::Emitter::Type::spot, .value = triple(intensity, "intensity"), .position = triple(position, "position"),
                                              .direction = triple(direction, "direction"), .cutoff_degrees = cutoff_degrees, .beam_degrees = beam_degrees, .medium = medium});
    });
}

tyndall_status tyndall_add_directional(tyndall_description* description, const double* irradiance, const double* direction)
{
    return guarded([&] {
        data(description).emitters.push_back({.type = api::Emitter::Type::directional, .value = triple(irradiance, "irradiance"), .direction = triple(direction, "direction")});
    });
}

tyndall_status tyndall_add_constant(tyndall_description* description, const double* radiance)
{
    return guarded([&] { data(description).emitters.push_back({.type = api::Emitter::Type::constant, .value = triple(radiance, "radiance")}); });
}

tyndall_status tyndall_set_max_depth(tyndall_description* description, int max_depth)
{
    return guarded([&] { data(description).max_depth = max_depth; });
}

tyndall_status tyndall_set_camera(tyndall_description* description, const double* origin, const double* target, const double* up, double fov_degrees, int width, int height, int medium)
{
    return guarded([&] {
        api::Camera& camera = data(description).camera;
        camera.origin = triple(origin, "origin"), camera.target = triple(target, "target"), camera.up = triple(up, "up");
        camera.fov_degrees = fov_degrees, camera.width = width, camera.height = height, camera.medium = medium;
    });
}

}  // extern "C"

/// A scene from memory: a box of fog over a floor, lit by a spot. Renders 8 passes, says how far it is, and writes fog.exr, fog.png and fog.json.
#include <tyndall/tyndall.hpp>

#include <cstdio>

using namespace tyndall::api;

static Mesh box_of_fog(int medium, int null_bsdf)
{
    Mesh box{.name = "box", .bsdf = null_bsdf, .interior = medium, .exterior = vacuum};
    for (double z : {-1, 1})
        for (double y : {-1, 1})
            for (double x : {-1, 1}) box.vertices.push_back({x, y, z});
    box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return box;
}

int main(int argc, char** argv)
try {
    SceneDescription scene;
    scene.media = {{.name = "fog", .sigma_t = {.8, .9, 1}, .albedo = {.9, .9, .9}, .phase = {.type = Phase::Type::henyey_greenstein, .g = .5}}};
    scene.bsdfs = {{.name = "boundary", .type = Bsdf::Type::null}, {.name = "floor", .reflectance = {.6, .5, .4}, .two_sided = true}};
    scene.meshes = {box_of_fog(0, 0), {.name = "floor", .vertices = {{-4, -1.1, -4}, {4, -1.1, -4}, {4, -1.1, 4}, {-4, -1.1, 4}}, .triangles = {{0, 2, 1}, {0, 3, 2}}, .bsdf = 1}};
    scene.emitters = {{.name = "spot", .type = Emitter::Type::spot, .value = {60, 60, 50}, .position = {2, 3, 1}, .direction = {-2, -3, -1}}};
    scene.camera = {.origin = {0, .5, 6}, .target = {0, -.2, 0}, .fov_degrees = 35, .width = 64, .height = 48};

    const RenderOptions options{.progress = [](const Progress& p, const Preview&) { return std::printf("pass %d of %d\n", p.passes_done, p.passes_wanted) > 0; },
                                .log = [](LogLevel, const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); }};
    const Image image = render(Scene(scene), {.passes = 8}, options);
    image.write(argc > 1 ? argv[1] : "fog.exr");
    std::printf("%d x %d pixels, error %.1f %%\n", image.width(), image.height(), 100 * image.error());
    return 0;
} catch (const tyndall::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}

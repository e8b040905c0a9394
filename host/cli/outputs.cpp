#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <set>

#include "film/atomic_file.hpp"
#include "film/film_image.hpp"
#include "film/png.hpp"
#include "film/tone_map.hpp"
#include "report/report_output.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

std::string methods_of(const Report& report)
{
    std::string methods;
    for (const auto& layer : report.layers)
        if (!layer.skipped) methods += (methods.empty() ? "" : ", ") + layer.layer + ": " + layer.technique;
    return methods;
}

std::string effects_of(const Report& report)
{
    std::string effects;
    for (const auto& effect : report.effects)
        if (effect.found) effects += (effects.empty() ? "" : " ") + effect.effect;
    return effects;
}

void add_text(ExrImage& image, const char* name, const std::string& text)
{
    if (!text.empty()) image.attributes[std::string("tyndall.") + name] = text;
}

/// Everything that the pixels depend on, and how good they are. 64-bit numbers are text: OpenEXR's integers have 32 bits.
void add_attributes(ExrImage& image, const Film& film, const Report& report, bool timestamps)
{
    add_text(image, "version", report.version);
    add_text(image, "scene", fs::path(report.scene).filename().string());
    add_text(image, "scene_hash", fmt::format("{:016x}", report.scene_hash));
    add_text(image, "seed", fmt::to_string(report.seed));
    add_text(image, "lights", fmt::to_string(report.virtual_lights));
    add_text(image, "method", report.method);
    add_text(image, "methods", methods_of(report));
    add_text(image, "effects", effects_of(report));
    add_text(image, "device", report.device);
    add_text(image, "driver", report.driver);
    add_text(image, "build_options", report.build_options);
    image.attributes["tyndall.passes"] = film.passes();
    image.attributes["tyndall.block_passes"] = film.block_passes();
    image.attributes["tyndall.lanes"] = report.lanes;
    image.attributes["tyndall.max_depth"] = report.max_depth;
    if (report.error >= 0) image.attributes["tyndall.error"] = report.error;
    if (timestamps) image.attributes["tyndall.seconds"] = report.seconds;
}

}  // namespace

OutputPaths plan_outputs(const fs::path& scene, const fs::path& output, const fs::path& report)
{
    OutputPaths paths{.exr = output.empty() ? fs::path(scene.stem()) += ".exr" : output};
    if (paths.exr.extension() != ".exr")
        throw UsageError(
            fmt::format("-o \"{}\": must end in .exr; the picture (.png) and the report (.json) are written beside it", output.string()));
    paths.png = fs::path(paths.exr).replace_extension(".png");
    paths.report = report.empty() ? fs::path(paths.exr).replace_extension(".json") : report;
    const std::set<fs::path> names{fs::absolute(paths.exr).lexically_normal(), fs::absolute(paths.png).lexically_normal(),
                                   fs::absolute(paths.report).lexically_normal(), fs::absolute(scene).lexically_normal()};
    if (names.size() < 4)
        throw UsageError(fmt::format("--report \"{}\": scene, image, picture and report need different names", report.string()));
    return paths;
}

fs::path plan_shard(const fs::path& scene, const fs::path& output, int number, int of)
{
    const int digits = static_cast<int>(fmt::to_string(of).size());
    fs::path file = output.empty() ? fs::path(scene.stem()) += fmt::format(".{:0{}}-of-{}.shard", number, digits, of) : output;
    if (file.extension() != ".shard") throw UsageError(fmt::format("-o \"{}\": the file of a shard must end in .shard; `tyndall merge` writes the image", output.string()));
    return file;
}

void make_folder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw IoError(fmt::format("{}: the folder cannot be made: {}; name another one with -o", folder.string(), error.message()));
}

void check_outputs(const OutputPaths& paths)
{
    for (const auto& path : {paths.exr, paths.png, paths.report}) check_writable(path);
}

void write_outputs(const OutputPaths& paths, const Film& film, const FilmWindow& window, const ImageWishes& wishes, const LayerSet& asked, Report& report)
{
    ExrImage image = to_exr_image(film, window, {wishes.half, asked});
    add_attributes(image, film, report, wishes.timestamps);
    write_exr(paths.exr, image);
    const auto beauty = film.beauty();
    report.exposure = wishes.exposure ? *wishes.exposure : automatic_exposure(beauty);
    write_png(paths.png, beauty, film.width(), *report.exposure);
    report.outputs = {paths.exr.string(), paths.png.string(), paths.report.string()};
    write_atomically(paths.report, to_json(report));
}

}  // namespace tyndall

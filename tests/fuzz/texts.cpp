/// Scenes and values of options.
#include <string>

#include "cli/parse_values.hpp"
#include "promises.hpp"
#include "scene/load_scene.hpp"
#include "targets.hpp"
#include "tyndall/error.hpp"

namespace tyndall::fuzz {
namespace {

void check_medium(const Scene& scene, const Medium& medium)
{
    require(medium.sigma_t.x >= 0 && medium.sigma_t.y >= 0 && medium.sigma_t.z >= 0, "extinction is not negative");
    require(finite(medium.sigma_t), "extinction is finite");
    (void)scene;
}

void check_scene(const Scene& scene)
{
    for (const Shape& shape : scene.shapes)
        if (shape.type == Shape::Type::mesh) check_mesh(shape.mesh);
    for (const Medium& medium : scene.media) check_medium(scene, medium);
    require(scene.unit > 0 && std::isfinite(scene.unit), "the unit of length is a number");
    require(finite(scene.centre), "the centre is finite");
}

void integers(const std::string& text)
{
    const auto value = parse_integer("--passes", text, 1, 1000);
    require(value >= 1 && value <= 1000, "a whole number is in range");
}

void decimals(const std::string& text)
{
    const double value = parse_number("--exposure", text, -64, 64), share = parse_share("--skip-thin", text);
    require(value >= -64 && value <= 64 && share >= 0 && share < 1, "a number is in range");
}

void durations(const std::string& text)
{
    const double seconds = parse_duration("--time", text);
    require(seconds > 0 && seconds <= 366. * 24 * 3600, "a duration is positive and at most a year");
}

void pairs(const std::string& text)
{
    const auto [width, height] = parse_resolution("--resolution", text);
    require(width >= 1 && width <= 65536 && height >= 1 && height <= 65536, "a resolution is in range");
}

void shard(const std::string& text)
{
    const auto [number, of] = parse_shard("--shard", text);
    require(number >= 1 && number <= of && of <= 65536, "a shard is one of those that there are");
}

void crop(const std::string& text)
{
    const Crop c = parse_crop("--crop", text);
    require(c.x >= 0 && c.y >= 0 && c.width >= 1 && c.height >= 1, "a crop has pixels");
}

void layers(const std::string& text)
{
    LayerWishes wishes;
    parse_layer_wishes("--layer", text, wishes);
    require(!wishes.kept().empty(), "a wish keeps a layer");
}

void definition(const std::string& text) { require(!parse_definition("-D", text).first.empty(), "a definition has a name"); }

}  // namespace

void scene(Bytes bytes)
{
    try {
        check_scene(parse_scene(std::string(text_of(bytes)), std::string(TYNDALL_SOURCE_DIR) + "/tests/fuzz/files", "scene.xml"));
    } catch (const SceneError&) {
    }
}

void numbers(Bytes bytes)
{
    if (bytes.empty()) return;
    const std::string text(text_of(bytes.subspan(1)));
    constexpr void (*options[])(const std::string&) = {
        integers, decimals, durations, pairs, shard, crop, layers, definition,
        [](const std::string& t) { parse_unsigned("--seed", t); },
        [](const std::string& t) { parse_features("--features", t); },
        [](const std::string& t) { parse_lanes("--lanes", t); },
        [](const std::string& t) { parse_method("--method", t); },
    };
    try {
        options[bytes[0] % std::size(options)](text);
    } catch (const UsageError&) {
    }
}

}  // namespace tyndall::fuzz

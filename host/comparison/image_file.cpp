#include "comparison/image_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "film/exr.hpp"
#include "scene/text.hpp"
#include "tyndall/error.hpp"
#include "tyndall/layer.hpp"

namespace tyndall {
namespace {

constexpr const char* whole_image = "image";

std::string channel_prefix(const std::string& layer) { return layer == whole_image ? "" : layer + "."; }

bool has_colours(const ExrImage& image, const std::string& layer)
{
    const std::string prefix = channel_prefix(layer);
    return image.channels.contains(prefix + "R") && image.channels.contains(prefix + "G") && image.channels.contains(prefix + "B");
}

/// "image" and every name with three colours.
std::vector<std::string> layers_of(const ExrImage& image)
{
    std::vector<std::string> names;
    if (has_colours(image, whole_image)) names.emplace_back(whole_image);
    for (const auto& [channel, values] : image.channels) {
        if (!channel.ends_with(".R")) continue;
        const std::string layer = channel.substr(0, channel.size() - 2);
        if (has_colours(image, layer)) names.push_back(layer);
    }
    return names;
}

void require_layer(const std::filesystem::path& file, const ExrImage& image, const std::string& layer)
{
    if (has_colours(image, layer)) return;
    const auto known = layers_of(image);
    throw SceneError(fmt::format("{}: has no layer {}{}; {}", file.string(), in_quotes(layer), suggestion(layer, known),
                                 known.empty() ? "it has no colours at all (channels R, G, B)" : "it has " + join(known)));
}

void add_layer(const std::filesystem::path& file, const ExrImage& image, const std::string& layer, std::vector<Rgb>& pixels)
{
    static constexpr std::array colours{"R", "G", "B"};
    std::size_t bad = 0;
    std::string first;
    for (int c = 0; c < 3; ++c) {
        const std::string channel = channel_prefix(layer) + colours[static_cast<std::size_t>(c)];
        const auto& values = image.channels.at(channel).values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            pixels[i][c] += values[i];
            if (std::isfinite(values[i]) || bad++) continue;
            const std::size_t width = static_cast<std::size_t>(image.width);
            first = fmt::format("{} in channel {} at pixel ({}, {})", values[i], channel, i % width, i / width);
        }
    }
    if (bad) throw SceneError(fmt::format("{}: {} values are not finite, the first is {}; an error against it means nothing: render it again", file.string(), bad, first));
}

std::string text_attribute(const ExrImage& image, const char* name)
{
    const auto found = image.attributes.find(name);
    const auto* text = found == image.attributes.end() ? nullptr : std::get_if<std::string>(&found->second);
    return text ? *text : "";
}

std::string size_of(const ImageFile& image) { return fmt::format("{} x {} pixels at ({}, {})", image.width, image.height, image.x, image.y); }

}  // namespace

ImageFile load_image_file(const std::filesystem::path& file, const std::vector<std::string>& layers)
{
    const ExrImage image = read_exr(file);
    ImageFile loaded{.file = file, .x = image.x, .y = image.y, .width = image.width, .height = image.height};
    const std::vector<std::string> wanted = layers.empty() ? std::vector<std::string>{whole_image} : layers;
    for (const std::string& layer : wanted) require_layer(file, image, layer);
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    loaded.pixels.assign(count, Rgb(0));
    for (const std::string& layer : wanted) add_layer(file, image, layer, loaded.pixels);
    if (wanted == std::vector<std::string>{whole_image} && has_colours(image, "variance")) {
        loaded.variance.assign(count, Rgb(0));
        add_layer(file, image, "variance", loaded.variance);
        if (const auto passes = image.attributes.find("tyndall.passes"); passes != image.attributes.end())
            if (const int* n = std::get_if<int>(&passes->second); n && *n < 2) loaded.variance.clear();  // zeros that stand for unknown
    }
    loaded.scene_hash = text_attribute(image, "tyndall.scene_hash"), loaded.method = text_attribute(image, "tyndall.method");
    return loaded;
}

std::map<std::string, std::vector<Rgb>> load_known_layers(const std::filesystem::path& file)
{
    const ExrImage image = read_exr(file);
    std::map<std::string, std::vector<Rgb>> layers;
    for (const std::string_view known : layer_names) {
        const std::string layer(known);
        if (!has_colours(image, layer)) continue;
        layers[layer].assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), Rgb(0));
        add_layer(file, image, layer, layers[layer]);
    }
    return layers;
}

void require_same_window(const ImageFile& image, const ImageFile& reference)
{
    if (image.width == reference.width && image.height == reference.height && image.x == reference.x && image.y == reference.y) return;
    throw SceneError(fmt::format("{}: shows {}, but {} shows {}; render one of them again with --resolution and --crop of the other", image.file.string(), size_of(image),
                                 reference.file.string(), size_of(reference)));
}

}  // namespace tyndall

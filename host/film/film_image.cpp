#include "film/film_image.hpp"

namespace tyndall {
namespace {

/// Adds the three components of `values` as channels `prefix` + each of `names`.
void add_channels(ExrImage& image, const std::string& prefix, const char* names, const std::vector<Vec3>& values, bool half)
{
    for (int c = 0; c < 3; ++c) {
        auto& channel = image.channels[prefix + names[c]];
        channel.half = half;
        channel.values.reserve(values.size());
        for (const auto& value : values) channel.values.push_back(static_cast<float>(value[c]));
    }
}

void add_features(ExrImage& image, const PixelFeatures& features, bool half)
{
    add_channels(image, "albedo.", "RGB", features.albedo, half);
    add_channels(image, "N.", "XYZ", features.normal, half);
    image.channels["Z"].values.assign(features.depth.begin(), features.depth.end());
}

}  // namespace

ExrImage to_exr_image(const Film& film, const FilmWindow& window, const FilmImageOptions& options)
{
    ExrImage image;
    image.x = window.x, image.y = window.y, image.width = film.width(), image.height = film.height();
    image.display_width = window.full_width, image.display_height = window.full_height;
    add_channels(image, "", "RGB", film.beauty(), options.half);
    for (std::size_t l = 0; l < layer_count; ++l) {
        const auto layer = static_cast<Layer>(l);
        const bool main_layer = l <= static_cast<std::size_t>(Layer::media_to_surface);
        if (film.has(layer) || (main_layer && (film.layers() | options.layers).contains(layer)))
            add_channels(image, std::string(name(layer)) + ".", "RGB", film.mean(layer), options.half);
    }
    add_channels(image, "variance.", "RGB", film.variance_of_mean(), false);
    image.channels["samples"].values.assign(film.pixels(), static_cast<float>(film.passes()));
    if (const auto features = film.features()) add_features(image, *features, options.half);
    return image;
}

}  // namespace tyndall

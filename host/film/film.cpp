#include "film/film.hpp"

#include <cassert>
#include <cmath>

namespace tyndall {
namespace {

Rgb variance_of_mean_from(const Rgb& sum, const Rgb& squares, int passes)
{
    if (passes < 2) return Rgb(0);
    const double n = passes;
    return glm::max(Rgb(0), squares - sum * sum / n) / (n * (n - 1));
}

template <class T>
std::vector<T> means(const BlockSum<T>& sum, std::size_t pixels, int passes)
{
    std::vector<T> mean(pixels, T(0));
    if (passes > 0)
        for (std::size_t i = 0; i < pixels; ++i) mean[i] = sum.value(i) / static_cast<double>(passes);
    return mean;
}

template <class Function>
std::vector<Rgb> per_pixel(std::size_t pixels, Function&& function)
{
    std::vector<Rgb> image(pixels);
    for (std::size_t i = 0; i < pixels; ++i) image[i] = function(i);
    return image;
}

}  // namespace

Film::Film(int width, int height, LayerSet layers, FilmOptions options) : width_(width), height_(height), layers_(layers), options_(options)
{
    assert(width > 0 && height > 0 && options.block_passes > 0);
}

Rgb Film::finite_or_ledger(Layer layer, std::size_t pixel, const Rgb& value)
{
    if (std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)) return value;
    ++ledger_.count;
    if (ledger_.first_cases.size() < NotFiniteLedger::kept_cases)
        ledger_.first_cases.push_back({passes_, layer, static_cast<int>(pixel % width_), static_cast<int>(pixel / width_)});
    return Rgb(0);
}

void Film::add_layer(Layer layer, const std::vector<Rgb>& image, std::vector<Rgb>& beauty)
{
    assert(image.size() == pixels());
    const auto index = static_cast<std::size_t>(layer);
    sums_[index].prepare(pixels());
    if (options_.layer_variance) squares_[index].prepare(pixels());
    const std::vector<Rgb> before = mean(layer);
    std::vector<Rgb> values(image.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb value = values[i] = finite_or_ledger(layer, i, image[i]);
        sums_[index].add(i, value);
        if (options_.layer_variance) squares_[index].add(i, value * value);
        beauty[i] += value;
    }
    spreads_[index].add(values, before, passes_);
}

void Film::add_features(const PixelFeatures& features)
{
    assert(features.albedo.size() == pixels() && features.normal.size() == pixels() && features.depth.size() == pixels());
    albedo_.prepare(pixels()), normal_.prepare(pixels()), depth_.prepare(pixels());
    for (std::size_t i = 0; i < pixels(); ++i) {
        albedo_.add(i, features.albedo[i]);
        normal_.add(i, features.normal[i]);
        depth_.add(i, features.depth[i]);
    }
}

void Film::close_block()
{
    for (auto& sum : sums_)
        if (!sum.empty()) sum.close_block();
    for (auto& sum : squares_)
        if (!sum.empty()) sum.close_block();
    beauty_squares_.close_block();
    if (!albedo_.empty()) albedo_.close_block(), normal_.close_block(), depth_.close_block();
}

void Film::add_pass(const PassImage& image, const PixelFeatures* features)
{
    assert(image.width == width_ && image.height == height_);
    std::vector<Rgb> beauty(pixels(), Rgb(0));
    const std::vector<Rgb> before = this->beauty();
    for (std::size_t l = 0; l < layer_count; ++l) {
        if (!layers_.contains(static_cast<Layer>(l))) continue;
        if (!image.layers[l].empty()) add_layer(static_cast<Layer>(l), image.layers[l], beauty);
        else if (!sums_[l].empty()) spreads_[l].add(std::vector<Rgb>(pixels(), Rgb(0)), mean(static_cast<Layer>(l)), passes_);
    }
    beauty_spread_.add(beauty, before, passes_);
    beauty_squares_.prepare(pixels());
    for (std::size_t i = 0; i < pixels(); ++i) beauty_squares_.add(i, beauty[i] * beauty[i]);
    if (features) add_features(*features);
    if (++passes_ % options_.block_passes == 0) close_block();
}

std::vector<Rgb> Film::mean(Layer layer) const { return means(sum_of(layer), pixels(), passes_); }

Rgb Film::beauty(std::size_t pixel) const
{
    if (passes_ == 0) return Rgb(0);
    Rgb sum(0);
    for (const auto& layer : sums_) sum += layer.value(pixel);
    return sum / static_cast<double>(passes_);
}

std::vector<Rgb> Film::beauty() const
{
    return per_pixel(pixels(), [&](std::size_t i) { return beauty(i); });
}

Rgb Film::variance_of_mean(std::size_t pixel) const
{
    return variance_of_mean_from(beauty(pixel) * static_cast<double>(passes_), beauty_squares_.value(pixel), passes_);
}

std::vector<Rgb> Film::variance_of_mean() const
{
    return per_pixel(pixels(), [&](std::size_t i) { return variance_of_mean(i); });
}

std::vector<Rgb> Film::variance_of_mean(Layer layer) const
{
    assert(options_.layer_variance);
    const auto& squares = squares_[static_cast<std::size_t>(layer)];
    return per_pixel(pixels(), [&](std::size_t i) { return variance_of_mean_from(sum_of(layer).value(i), squares.value(i), passes_); });
}

std::optional<PixelFeatures> Film::features() const
{
    if (albedo_.empty()) return std::nullopt;
    return PixelFeatures{means(albedo_, pixels(), passes_), means(normal_, pixels(), passes_), means(depth_, pixels(), passes_)};
}

std::size_t Film::memory_bytes() const
{
    std::size_t bytes = beauty_squares_.memory_bytes() + albedo_.memory_bytes() + normal_.memory_bytes() + depth_.memory_bytes();
    for (const auto& sum : sums_) bytes += sum.memory_bytes();
    for (const auto& sum : squares_) bytes += sum.memory_bytes();
    return bytes;
}

}  // namespace tyndall

#include "film/film.hpp"

#include <algorithm>
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
        ledger_.first_cases.push_back({options_.first_pass + passes_, layer, static_cast<int>(pixel % width_), static_cast<int>(pixel / width_)});
    return Rgb(0);
}

void Film::add_layer(Layer layer, const std::vector<Rgb>& image, std::vector<Rgb>& beauty)
{
    assert(image.size() == pixels() || image.empty());
    const auto index = static_cast<std::size_t>(layer);
    if (image.empty() && sums_[index].empty()) return;
    sums_[index].prepare(pixels()), deviations_[index].prepare(pixels());
    if (options_.layer_variance) squares_[index].prepare(pixels());
    for (std::size_t i = 0; i < pixels(); ++i) {
        const Rgb value = image.empty() ? Rgb(0) : finite_or_ledger(layer, i, image[i]);
        deviations_[index].add(i, value, sums_[index].block_value(i), in_block());
        sums_[index].add(i, value);
        if (options_.layer_variance) squares_[index].add(i, value * value);
        beauty[i] += value;
    }
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

void Film::close_full_block()
{
    if (in_block() < options_.block_passes) return;
    for (std::size_t l = 0; l < layer_count; ++l) {
        const auto& sum = sums_[l];
        if (!sum.empty())
            deviations_[l].close_block([&](std::size_t i) { return sum.block_value(i); }, [&](std::size_t i) { return sum.value(i); }, in_block(), finished_);
    }
    each_sum(*this, [](auto& sum) {
        if (!sum.empty()) sum.close_block();
    });
    finished_ = passes_;
}

void Film::add_pass(const PassImage& image, const PixelFeatures* features)
{
    assert(image.width == width_ && image.height == height_);
    close_full_block();
    std::vector<Rgb> before = per_pixel(pixels(), [&](std::size_t i) {
        Rgb sum(0);
        for (const auto& layer : sums_) sum += layer.block_value(i);
        return sum;
    });
    std::vector<Rgb> beauty(pixels(), Rgb(0));
    for (std::size_t l = 0; l < layer_count; ++l)
        if (layers_.contains(static_cast<Layer>(l))) add_layer(static_cast<Layer>(l), image.layers[l], beauty);
    spread_.add(beauty, std::move(before), in_block(), options_.block_passes);
    beauty_squares_.prepare(pixels());
    for (std::size_t i = 0; i < pixels(); ++i) beauty_squares_.add(i, beauty[i] * beauty[i]);
    if (features) add_features(*features);
    ++passes_;
}

bool Film::same_kind(const Film& other) const
{
    return width_ == other.width_ && height_ == other.height_ && layers_ == other.layers_ && options_.block_passes == other.options_.block_passes &&
           options_.layer_variance == other.options_.layer_variance;
}

void Film::append(Film&& block)
{
    assert(same_kind(block) && block.finished_ == 0 && block.options_.first_pass == options_.first_pass + passes_ && passes_ % options_.block_passes == 0);
    close_full_block();
    for (std::size_t l = 0; l < layer_count; ++l) {
        sums_[l].take_block(std::move(block.sums_[l])), squares_[l].take_block(std::move(block.squares_[l]));
        deviations_[l].take_block(std::move(block.deviations_[l]));
        if (!sums_[l].empty()) deviations_[l].prepare(pixels());
    }
    beauty_squares_.take_block(std::move(block.beauty_squares_));
    albedo_.take_block(std::move(block.albedo_)), normal_.take_block(std::move(block.normal_)), depth_.take_block(std::move(block.depth_));
    spread_.append(block.spread_);
    ledger_.count += block.ledger_.count;
    for (const NotFinitePixel& pixel : block.ledger_.first_cases)
        if (ledger_.first_cases.size() < NotFiniteLedger::kept_cases) ledger_.first_cases.push_back(pixel);
    passes_ += block.passes_;
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

double Film::relative_mse(Layer layer) const
{
    const auto& sum = sum_of(layer);
    return deviations_[static_cast<std::size_t>(layer)].relative_mse([&](std::size_t i) { return sum.block_value(i); }, [&](std::size_t i) { return sum.value(i); }, in_block(),
                                                                     finished_);
}

std::size_t Film::memory_bytes() const
{
    std::size_t bytes = 0;
    each_sum(*this, [&](const auto& sum) { bytes += sum.memory_bytes(); });
    for (const auto& deviation : deviations_) bytes += deviation.memory_bytes();
    return bytes;
}

}  // namespace tyndall

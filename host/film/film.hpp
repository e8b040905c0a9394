#pragma once
/// The film: sums of passes per layer and pixel in double, from which image and error bars follow.
///
/// Passes are grouped in fixed blocks of B consecutive passes. The film keeps the sum of the block in progress and the total of the
/// finished blocks; both are added in order. Floating-point sums do not re-associate, so this fixed grouping is what lets films that were
/// rendered in whole blocks elsewhere add up to the same bytes as one long render (`append`). A block is added to the total when the next one begins.
#include <cstdint>
#include <optional>
#include <vector>

#include "film/block_sum.hpp"
#include "film/layer_deviation.hpp"
#include "film/pass_image.hpp"
#include "film/pass_spread.hpp"

namespace tyndall {

class ByteReader;
class ByteWriter;

struct FilmOptions {
    int block_passes = 8;         ///< B, at least 1. Part of the result: films with different B are not byte-equal
    int first_pass = 0;           ///< number of the first pass, for the ledger; a multiple of B
    bool layer_variance = false;  ///< keep the squares of every layer too (24 to 48 bytes per pixel and layer)
};

/// A pixel of a layer that was NaN or infinite in one pass. It counts as 0 there.
struct NotFinitePixel {
    int pass = 0;  ///< from 0
    Layer layer = Layer::emitted;
    int x = 0, y = 0;  ///< within the film
};

/// All pixels that were not finite, and the first few of them by coordinate: nothing is dropped silently.
struct NotFiniteLedger {
    static constexpr std::size_t kept_cases = 8;
    std::uint64_t count = 0;
    std::vector<NotFinitePixel> first_cases;
};

class Film {
public:
    /// A black film of width x height pixels (both at least 1) for the layers of the set. Memory is taken when a layer is first added to.
    Film(int width, int height, LayerSet layers, FilmOptions options = {});

    /// Adds the next pass. The image has the film's size; layers outside the film's set are ignored, empty ones count as black.
    /// Features, if given, come with every pass or with none.
    void add_pass(const PassImage& image, const PixelFeatures* features = nullptr);

    /// Adds a film of the block that follows: at most B passes, the first of which has the number of this film's passes; same size, layers and options. The result is
    /// byte-equal to having added its passes here.
    void append(Film&& block);

    /// Are size, layers and options the same, but for the number of the first pass?
    bool same_kind(const Film& other) const;
    /// Bytes that hold everything, and a film from them. `load` throws SceneError for bytes that hold no film.
    void save(ByteWriter& writer) const;
    static Film load(ByteReader& reader);

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t pixels() const { return static_cast<std::size_t>(width_) * height_; }
    int passes() const { return passes_; }
    int first_pass() const { return options_.first_pass; }
    int block_passes() const { return options_.block_passes; }
    LayerSet layers() const { return layers_; }
    /// Did any pass bring this layer? Otherwise its mean is black.
    bool has(Layer layer) const { return !sum_of(layer).empty(); }

    /// Mean over the passes, row-major, top row first; black before the first pass.
    std::vector<Rgb> mean(Layer layer) const;
    /// Sum of the layers' means.
    std::vector<Rgb> beauty() const;
    /// One pixel of `beauty()`, for callers that stream.
    Rgb beauty(std::size_t pixel) const;

    /// Unbiased variance of the mean of the beauty per pixel and channel: (sum of squares - sum^2 / n) / (n (n - 1)); 0 below two passes.
    /// Rounding can push the difference below 0 by at most about n units in the last place of the sum of squares; it is 0 then.
    std::vector<Rgb> variance_of_mean() const;
    /// One pixel of `variance_of_mean()`.
    Rgb variance_of_mean(std::size_t pixel) const;
    /// The same of one layer; needs FilmOptions::layer_variance.
    std::vector<Rgb> variance_of_mean(Layer layer) const;

    /// How far the passes' beauty lies from each other.
    const PassSpread& spread() const { return spread_; }
    /// relMSE of a layer's mean relative to the layer itself, from how far its passes lie from each other; negative below two passes or without the layer.
    double relative_mse(Layer layer) const;

    /// Means of the features, if passes brought them.
    std::optional<PixelFeatures> features() const;

    const NotFiniteLedger& not_finite() const { return ledger_; }
    /// Bytes that the sums take now.
    std::size_t memory_bytes() const;

private:
    using Sums = std::array<BlockSum<Rgb>, layer_count>;
    const BlockSum<Rgb>& sum_of(Layer layer) const { return sums_[static_cast<std::size_t>(layer)]; }
    Rgb finite_or_ledger(Layer layer, std::size_t pixel, const Rgb& value);
    void add_layer(Layer layer, const std::vector<Rgb>& image, std::vector<Rgb>& beauty);
    void add_features(const PixelFeatures& features);
    /// Adds the block in progress to the total if it is full.
    void close_full_block();
    int in_block() const { return passes_ - finished_; }
    /// Calls `visit(sum)` for every BlockSum.
    template <class Self, class Visit>
    static void each_sum(Self& film, Visit&& visit)
    {
        for (auto& sum : film.sums_) visit(sum);
        for (auto& sum : film.squares_) visit(sum);
        visit(film.beauty_squares_), visit(film.albedo_), visit(film.normal_), visit(film.depth_);
    }
    template <class Stream, class Self>
    static void each_field(Stream& stream, Self& film);
    bool fits_together() const;

    int width_, height_, passes_ = 0, finished_ = 0;  ///< finished: passes of the finished blocks
    LayerSet layers_;
    FilmOptions options_;
    Sums sums_, squares_;
    BlockSum<Rgb> beauty_squares_, albedo_;
    BlockSum<Vec3> normal_;
    BlockSum<double> depth_;
    std::array<LayerDeviation, layer_count> deviations_;
    PassSpread spread_;
    NotFiniteLedger ledger_;
};

}  // namespace tyndall

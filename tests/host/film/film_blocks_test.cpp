/// Films in pieces: blocks rendered apart, films saved and gone on with. Everything is compared as bytes.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "film/error_estimate.hpp"
#include "scene/byte_stream.hpp"

namespace tyndall {
namespace {

constexpr int width = 3, height = 2, pixels = width * height;

LayerSet three_layers() { return LayerSet().add(Layer::single).add(Layer::media_to_media).add(Layer::single_specular); }

double exponential(std::mt19937_64& random) { return std::exponential_distribution<double>()(random); }

/// Pass number `pass` of a render: its own random numbers, a layer that is sometimes missing and one that comes late, now and then a NaN.
struct Pass {
    PassImage image{width, height, LayerSet().add(Layer::single).add(Layer::media_to_media)};
    PixelFeatures features;

    explicit Pass(int pass)
    {
        std::mt19937_64 random(static_cast<std::uint64_t>(pass));
        if (pass % 5 == 3) image[Layer::media_to_media].clear();
        if (pass >= 10) image[Layer::single_specular].assign(pixels, Rgb(exponential(random)));
        for (auto& layer : image.layers)
            for (Rgb& pixel : layer) pixel = Rgb(exponential(random), exponential(random), exponential(random));
        if (pass % 3 == 1) image[Layer::single][static_cast<std::size_t>(pass % pixels)].y = std::numeric_limits<double>::quiet_NaN();
        features = {std::vector<Rgb>(pixels, Rgb(exponential(random))), std::vector<Vec3>(pixels, Vec3(exponential(random))), std::vector<double>(pixels, exponential(random))};
    }
};

void add_passes(Film& film, int from, int to)
{
    for (int i = from; i < to; ++i) {
        const Pass pass(i);
        film.add_pass(pass.image, &pass.features);
    }
}

std::vector<std::byte> bytes_of(const Film& film)
{
    std::vector<std::byte> bytes;
    ByteWriter writer([&](std::span<const std::byte> more) { bytes.insert(bytes.end(), more.begin(), more.end()); });
    film.save(writer);
    return bytes;
}

Film film_from(std::span<const std::byte> bytes)
{
    ByteReader reader(bytes);
    Film film = Film::load(reader);
    EXPECT_EQ(reader.left(), 0u);
    return film;
}

class FilmBlocks : public testing::TestWithParam<std::tuple<int, int, bool>> {
protected:
    const int passes = std::get<0>(GetParam()), block = std::get<1>(GetParam());
    FilmOptions options(int first = 0) const { return {.block_passes = block, .first_pass = first, .layer_variance = std::get<2>(GetParam())}; }
    Film whole(int to) const
    {
        Film film(width, height, three_layers(), options());
        add_passes(film, 0, to);
        return film;
    }
};

TEST_P(FilmBlocks, RenderedApartAddUpToTheSameBytes)
{
    Film sum(width, height, three_layers(), options());
    for (int first = 0; first < passes; first += block) {
        Film piece(width, height, three_layers(), options(first));
        add_passes(piece, first, std::min(first + block, passes));
        sum.append(film_from(bytes_of(piece)));
    }
    EXPECT_EQ(bytes_of(sum), bytes_of(whole(passes)));
    EXPECT_EQ(error_upper_bound(sum), error_upper_bound(whole(passes)));
}

TEST_P(FilmBlocks, SavedAtAnyPassGoOnToTheSameBytes)
{
    const auto expected = bytes_of(whole(passes));
    for (int stop = 0; stop <= passes; ++stop) {
        Film film = film_from(bytes_of(whole(stop)));
        add_passes(film, stop, passes);
        EXPECT_EQ(bytes_of(film), expected) << "stopped after " << stop;
    }
}

TEST_P(FilmBlocks, TheBytesHoldWhatAFilmTells)
{
    const Film film = whole(passes), again = film_from(bytes_of(film));
    EXPECT_EQ(again.beauty(), film.beauty());
    EXPECT_EQ(again.variance_of_mean(), film.variance_of_mean());
    EXPECT_EQ(again.not_finite().count, film.not_finite().count);
    EXPECT_EQ(estimated_error(again, Layer::single), estimated_error(film, Layer::single));
}

INSTANTIATE_TEST_SUITE_P(Of, FilmBlocks, testing::Combine(testing::Values(1, 8, 13, 29, 32), testing::Values(1, 3, 8), testing::Bool()));

TEST(FilmBytes, EveryTruncationIsRefused)
{
    Film film(width, height, three_layers());
    add_passes(film, 0, 11);
    const auto bytes = bytes_of(film);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        ByteReader reader(std::span<const std::byte>(bytes).first(size));
        EXPECT_THROW(Film::load(reader), SceneError) << size;
    }
}

TEST(FilmBytes, LiesAboutSizesAreRefusedWithoutTakingMemory)
{
    Film film(width, height, three_layers());
    add_passes(film, 0, 11);
    const auto good = bytes_of(film);
    for (std::size_t at = 0; at + 8 <= std::min<std::size_t>(good.size(), 400); ++at) {
        auto bad = good;
        const std::uint64_t lie = 0x00ffffffffffffffu;
        std::memcpy(bad.data() + at, &lie, 8);
        ByteReader reader(bad);
        try {
            Film::load(reader);  // some bytes are numbers that may be anything
        } catch (const SceneError&) {
        }
    }
}

TEST(Checksum, SeesEveryBitAndTheLength)
{
    std::vector<std::byte> bytes(37, std::byte(5));
    const auto of = [](std::span<const std::byte> b, std::size_t split) {
        Checksum sum;
        sum.add(b.first(split)), sum.add(b.subspan(split));
        return sum.value();
    };
    const std::uint64_t expected = of(bytes, 0);
    for (std::size_t split = 0; split <= bytes.size(); ++split) EXPECT_EQ(of(bytes, split), expected) << "pieces do not matter";
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        auto other = bytes;
        other[bit / 8] ^= std::byte(1u << (bit % 8));
        EXPECT_NE(of(other, 0), expected) << bit;
    }
    bytes.push_back(std::byte(0));
    EXPECT_NE(of(bytes, 0), expected);
}

}  // namespace
}  // namespace tyndall

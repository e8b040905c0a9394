/// A film as bytes, for state files (host/docs/farm.md).
#include "film/film.hpp"
#include "scene/byte_stream.hpp"

namespace tyndall {

template <>
inline constexpr bool stored_as_bytes<Rgb> = true;
template <>
inline constexpr bool stored_as_bytes<glm::vec3> = true;
static_assert(sizeof(Rgb) == 24 && sizeof(glm::vec3) == 12);

template <class Stream, class Self>
void fields(Stream& stream, Self& pixel)
    requires std::is_same_v<std::remove_const_t<Self>, NotFinitePixel>
{
    stream(pixel.pass), stream(pixel.layer), stream(pixel.x), stream(pixel.y);
}

template <class Stream, class Self>
void Film::each_field(Stream& stream, Self& film)
{
    stream(film.passes_), stream(film.finished_);
    each_sum(film, [&](auto& sum) { stream(sum); });
    for (auto& deviation : film.deviations_) stream(deviation);
    stream(film.spread_), stream(film.ledger_.count), stream(film.ledger_.first_cases);
}

void Film::save(ByteWriter& writer) const
{
    writer(width_), writer(height_), writer(options_.block_passes), writer(options_.first_pass), writer(options_.layer_variance);
    for (std::size_t l = 0; l < layer_count; ++l) writer(layers_.contains(static_cast<Layer>(l)));
    each_field(writer, *this);
}

bool Film::fits_together() const
{
    bool fits = passes_ >= finished_ && finished_ >= 0 && finished_ % options_.block_passes == 0 && in_block() <= options_.block_passes;
    each_sum(*this, [&](const auto& sum) { fits = fits && sum.fits(pixels()); });
    for (std::size_t l = 0; l < layer_count; ++l) fits = fits && deviations_[l].fits(pixels()) && deviations_[l].empty() == sums_[l].empty();
    for (const NotFinitePixel& pixel : ledger_.first_cases) fits = fits && static_cast<std::size_t>(pixel.layer) < layer_count;
    return fits && beauty_squares_.empty() == (passes_ == 0);
}

Film Film::load(ByteReader& reader)
{
    int width = 0, height = 0;
    FilmOptions options;
    LayerSet layers;
    reader(width), reader(height), reader(options.block_passes), reader(options.first_pass), reader(options.layer_variance);
    for (std::size_t l = 0; l < layer_count; ++l) {
        bool contains = false;
        reader(contains);
        if (contains) layers.add(static_cast<Layer>(l));
    }
    constexpr int widest = 1 << 16;
    if (width < 1 || width > widest || height < 1 || height > widest || options.block_passes < 1 || options.first_pass < 0) throw SceneError("the film in it makes no sense");
    Film film(width, height, layers, options);
    each_field(reader, film);
    if (!film.fits_together()) throw SceneError("the film in it makes no sense");
    return film;
}

}  // namespace tyndall

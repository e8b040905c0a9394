// PNG pictures. The one place of host/scene that knows libpng, which leaves its functions by long jumps: those jumps pass over no object that has a destructor.
#include <png.h>

#include <csetjmp>
#include <cstring>

#include <fmt/format.h>

#include "scene/picture_files.hpp"

namespace tyndall {
namespace {

struct Reading {
    std::string_view bytes;
    std::size_t at = 0;
    char fault[128] = "libpng cannot start";
    png_structp png = nullptr;
    png_infop info = nullptr;

    explicit Reading(std::string_view source) : bytes(source) {}
    Reading(const Reading&) = delete;
    ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }
};

void keep_fault(png_structp png, png_const_charp message)
{
    auto& reading = *static_cast<Reading*>(png_get_error_ptr(png));
    std::strncpy(reading.fault, message, sizeof reading.fault - 1);
    png_longjmp(png, 1);
}

void pass_over_warning(png_structp, png_const_charp) {}

void give_bytes(png_structp png, png_bytep target, png_size_t count)
{
    auto& reading = *static_cast<Reading*>(png_get_io_ptr(png));
    if (count > reading.bytes.size() - reading.at) png_error(png, "the file is cut off");
    std::memcpy(target, reading.bytes.data() + reading.at, count);
    reading.at += count;
}

/// Grey or colour of 8 or 16 bits, without alpha, whatever the file has. False: `fault` says why not.
bool read_header(Reading& reading)
{
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, keep_fault, pass_over_warning);
    if (reading.png) reading.info = png_create_info_struct(reading.png);
    if (!reading.info) return false;
    if (setjmp(png_jmpbuf(reading.png))) return false;  // NOLINT(cert-err52-cpp): how libpng reports
    png_set_read_fn(reading.png, &reading, give_bytes);
    png_read_info(reading.png, reading.info);
    png_set_palette_to_rgb(reading.png);
    png_set_expand_gray_1_2_4_to_8(reading.png);
    png_set_strip_alpha(reading.png);
    png_set_interlace_handling(reading.png);
    png_read_update_info(reading.png, reading.info);
    return true;
}

bool read_rows(Reading& reading, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(reading.png))) return false;  // NOLINT(cert-err52-cpp): how libpng reports
    png_read_image(reading.png, rows);
    png_read_end(reading.png, nullptr);
    return true;
}

}  // namespace

Picture read_png_picture(std::string_view bytes)
{
    Reading reading(bytes);
    const auto damaged = [&] { return PictureFault(fmt::format("is no PNG that can be read: {}", reading.fault)); };
    if (!read_header(reading)) throw damaged();
    const std::int64_t width = png_get_image_width(reading.png, reading.info), height = png_get_image_height(reading.png, reading.info);
    check_picture_size(width, height);
    Picture picture{.width = static_cast<int>(width), .height = static_cast<int>(height), .channels = png_get_channels(reading.png, reading.info), .encoded = true};
    if (picture.channels != 1 && picture.channels != 3) throw PictureFault(fmt::format("has {} channels; grey or colour is read", picture.channels));
    const std::size_t row_bytes = png_get_rowbytes(reading.png, reading.info), lines = static_cast<std::size_t>(height);
    std::vector<png_byte> pixels(row_bytes * lines);
    std::vector<png_bytep> rows(lines);
    for (std::size_t y = 0; y < lines; ++y) rows[y] = pixels.data() + y * row_bytes;
    if (!read_rows(reading, rows.data())) throw damaged();
    const bool wide = png_get_bit_depth(reading.png, reading.info) == 16;  // big-endian
    picture.values.resize(static_cast<std::size_t>(width * height) * static_cast<std::size_t>(picture.channels));
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        picture.values[i] = wide ? static_cast<float>(256 * pixels[2 * i] + pixels[2 * i + 1]) / 65535.f : static_cast<float>(pixels[i]) / 255.f;
    return picture;
}

}  // namespace tyndall

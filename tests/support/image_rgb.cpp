#include "image_rgb.hpp"

#include "film/exr.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {
namespace {

void add_layer(ImageRgb& sum, const ExrImage& image, const std::filesystem::path& file, const std::string& layer)
{
    const std::string prefix = layer.empty() ? "" : layer + ".";
    const bool grey = layer.empty() && !image.channels.contains("R") && image.channels.contains("Y");
    for (int c = 0; c < 3; ++c) {
        const auto channel = image.channels.find(grey ? "Y" : prefix + "RGB"[c]);
        if (channel == image.channels.end()) throw IoError(file.string() + ": has no channel \"" + prefix + "RGB"[c] + "\"");
        for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i][c] += channel->second.values[i];
    }
}

}  // namespace

ImageRgb read_layers(const std::filesystem::path& file, const std::vector<std::string>& layers)
{
    const ExrImage image = read_exr(file);
    ImageRgb sum{image.width, image.height, std::vector<Vec3>(static_cast<std::size_t>(image.width) * image.height, Vec3(0))};
    for (const auto& layer : layers) add_layer(sum, image, file, layer);
    return sum;
}

ImageRgb read_rgb(const std::filesystem::path& file, const std::string& layer) { return read_layers(file, {layer}); }

}  // namespace tyndall::test

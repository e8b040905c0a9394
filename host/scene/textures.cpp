// Textures of surfaces: bitmap, checkerboard.
#include <fmt/format.h>

#include <algorithm>

#include "scene/scene_builder.hpp"
#include "scene/text.hpp"

namespace tyndall {
namespace {

/// All bitmaps of a scene: 512 MiB.
constexpr std::size_t most_texels = std::size_t{1} << 27;

/// The largest value of each channel; refuses what is negative.
Rgb largest_texel(const Texture& texture, const Properties& properties)
{
    Rgb largest(0);
    const std::size_t channels = static_cast<std::size_t>(texture.channels), width = static_cast<std::size_t>(texture.width);
    for (std::size_t i = 0; i < texture.texels.size(); ++i) {
        const std::size_t texel = i / channels;
        if (!(texture.texels[i] >= 0 && texture.texels[i] <= 1))
            properties.refuse_parameter("filename", fmt::format("{}: pixel ({}, {}) is {}; a surface reflects between 0 and 1 of the light", printable(texture.name), texel % width, texel / width, texture.texels[i]));
        for (int c = 0; c < 3; ++c)
            if (channels == 1 || static_cast<std::size_t>(c) == i % channels) largest[c] = std::max(largest[c], double{texture.texels[i]});
    }
    return largest;
}

Texture read_bitmap(SceneBuilder& builder, Properties& properties)
{
    const bool raw = properties.boolean("raw", false);
    Picture picture = read_scene_picture(builder, properties, raw);
    Texture texture{.name = properties.text("filename", ""), .type = Texture::Type::bitmap, .width = picture.width, .height = picture.height, .channels = picture.channels, .texels = std::move(picture.values)};
    texture.filter = properties.choice("filter_type", "bilinear", {"bilinear", "nearest"}) == "nearest" ? Texture::Filter::nearest : Texture::Filter::bilinear;
    const std::string wrap = properties.choice("wrap_mode", "repeat", {"repeat", "mirror", "clamp"});
    texture.wrap = wrap == "mirror" ? Texture::Wrap::mirror : wrap == "clamp" ? Texture::Wrap::clamp : Texture::Wrap::repeat;
    properties.boolean("accel", true);  // graphics hardware, of which there is none here
    texture.largest = largest_texel(texture, properties);
    std::size_t texels = texture.texels.size();
    for (const Texture& other : builder.scene.textures) texels += other.texels.size();
    if (texels > most_texels) properties.refuse_parameter("filename", fmt::format("the pictures of the scene have {} values up to here; {} are possible", texels, most_texels));
    return texture;
}

Texture read_checkerboard(Properties& properties)
{
    Texture texture{.name = properties.id_or_type(), .type = Texture::Type::checkerboard};
    texture.even = properties.colour("color0", Rgb(.4), Range::between(0, 1));
    texture.odd = properties.colour("color1", Rgb(.2), Range::between(0, 1));
    texture.largest = glm::max(texture.even, texture.odd);
    return texture;
}

int read_texture(SceneBuilder& builder, const XmlElement& element)
{
    if (const auto known = builder.textures.find(&element); known != builder.textures.end()) return known->second;
    Properties properties(element, builder.document);
    const bool bitmap = properties.type() == "bitmap";
    if (!bitmap && properties.type() != "checkerboard") properties.refuse_type({"bitmap", "checkerboard"});
    Texture texture = bitmap ? read_bitmap(builder, properties) : read_checkerboard(properties);
    texture.to_uv = properties.transform("to_uv"), texture.where = properties.where();
    properties.finish();
    builder.scene.textures.push_back(std::move(texture));
    return builder.textures[&element] = static_cast<int>(builder.scene.textures.size()) - 1;
}

}  // namespace

SurfaceColour read_reflectance(SceneBuilder& builder, Properties& properties, const std::string& name, double fallback)
{
    const XmlElement* texture = properties.nested_as("texture", name);
    if (!texture) return {.largest = properties.colour(name, Rgb(fallback), Range::between(0, 1))};
    const int index = read_texture(builder, *texture);
    return {.largest = builder.scene.textures[static_cast<std::size_t>(index)].largest, .texture = index};
}

Picture read_scene_picture(SceneBuilder& builder, Properties& properties, bool raw)
{
    const std::string name = properties.text("filename", "");
    if (name.empty()) properties.refuse_parameter("filename", "needs <string name=\"filename\" value=\"...\"/>");
    const SourceLocation where = properties.where_is("filename");
    const SceneFiles::Content content = builder.files.read(name, where, largest_picture_file);
    try {
        Picture picture = read_picture(content.bytes);
        if (picture.encoded && !raw)
            for (float& value : picture.values) value = static_cast<float>(linear_from_srgb(value));
        return picture;
    } catch (const PictureFault& fault) {
        refuse(where, fmt::format("{}: {}: {}", properties.title(), printable(name), fault.what()));
    }
}

}  // namespace tyndall

/// The C interface: textures and environment maps of scenes from memory.
#include "library/c_description.hpp"

using namespace tyndall;

namespace {

/// Refuses sizes that no picture has before their product is taken.
std::vector<float> texels_of(const float* texels, int width, int height, int channels)
{
    if (width < 1 || height < 1 || width > 1 << 16 || height > 1 << 16) throw UsageError("a picture has 1 to 65536 pixels along each side");
    if (channels != 1 && channels != 3) throw UsageError("a picture has 1 or 3 channels");
    const std::size_t count = std::size_t(width) * std::size_t(height) * std::size_t(channels);
    return {&needed(texels, "texels"), texels + count};
}

}  // namespace

extern "C" {

tyndall_status tyndall_add_picture(tyndall_description* description, int width, int height, int channels, const float* texels, int* index)
{
    return guarded([&] {
        add(data(description).textures, api::Texture{.width = width, .height = height, .channels = channels, .texels = texels_of(texels, width, height, channels)}, index);
    });
}

tyndall_status tyndall_add_checkerboard(tyndall_description* description, const double* even, const double* odd, int* index)
{
    return guarded([&] {
        add(data(description).textures, api::Texture{.type = api::Texture::Type::checkerboard, .even = triple(even, "even"), .odd = triple(odd, "odd")}, index);
    });
}

tyndall_status tyndall_set_lookup(tyndall_description* description, int texture, int filter, int wrap, const double* to_uv)
{
    return guarded([&] {
        using Texture = api::Texture;
        Texture& of = added(data(description).textures, texture, "texture");
        if (filter != TYNDALL_BILINEAR && filter != TYNDALL_NEAREST) throw UsageError("filter is TYNDALL_BILINEAR or TYNDALL_NEAREST");
        if (wrap != TYNDALL_REPEAT && wrap != TYNDALL_MIRROR && wrap != TYNDALL_CLAMP) throw UsageError("wrap is TYNDALL_REPEAT, TYNDALL_MIRROR or TYNDALL_CLAMP");
        of.filter = filter == TYNDALL_NEAREST ? Texture::Filter::nearest : Texture::Filter::bilinear;
        of.wrap = wrap == TYNDALL_REPEAT ? Texture::Wrap::repeat : wrap == TYNDALL_MIRROR ? Texture::Wrap::mirror : Texture::Wrap::clamp;
        if (to_uv) std::copy(to_uv, to_uv + of.to_uv.size(), of.to_uv.begin());
    });
}

tyndall_status tyndall_set_textures(tyndall_description* description, int bsdf, int reflectance, int transmittance)
{
    return guarded([&] {
        const auto wanted = [&](int texture) {
            if (texture == TYNDALL_NO_TEXTURE) return std::optional<int>();
            added(data(description).textures, texture, "texture");
            return std::optional(texture);
        };
        api::Bsdf& of = added(data(description).bsdfs, bsdf, "bsdf");
        const auto first = wanted(reflectance), second = wanted(transmittance);
        const bool plastic = of.type == api::Bsdf::Type::plastic || of.type == api::Bsdf::Type::rough_plastic;
        (plastic ? of.below_texture : of.reflectance_texture) = first, of.transmittance_texture = second;
    });
}

tyndall_status tyndall_set_texture_coordinates(tyndall_description* description, int mesh, const double* uvs, size_t count)
{
    return guarded([&] {
        api::Mesh& of = added(data(description).meshes, mesh, "mesh");
        needed(uvs, "uvs"), of.uvs.clear();
        for (std::size_t i = 0; i < count; ++i) of.uvs.push_back({uvs[2 * i], uvs[2 * i + 1]});
    });
}

tyndall_status tyndall_add_environment(tyndall_description* description, int width, int height, const float* texels, const double* factor, const double* up, const double* middle)
{
    return guarded([&] {
        api::SceneDescription& to = data(description);
        api::EnvironmentMap map{.width = width, .height = height, .texels = texels_of(texels, width, height, 3)};
        api::Emitter light{.type = api::Emitter::Type::environment, .value = triple(factor, "factor"), .map = static_cast<int>(to.environment_maps.size())};
        if (up) light.up = triple(up, "up");
        if (middle) light.middle = triple(middle, "middle");
        to.environment_maps.push_back(std::move(map));
        to.emitters.push_back(std::move(light));
    });
}

}  // extern "C"

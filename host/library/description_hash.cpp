#include "library/description_hash.hpp"

#include <concepts>
#include <type_traits>

#include "scene/scene_hash.hpp"

namespace tyndall {
namespace {

/// Folds values into a hash, one after the other.
class Fold {
public:
    template <typename... Values>
    void all(const Values&... values) { (one(values), ...); }
    std::uint64_t value() const { return hash_.value(); }

private:
    template <typename Number>
        requires(std::is_arithmetic_v<Number> || std::is_enum_v<Number>)
    void one(const Number& number) { hash_.add({reinterpret_cast<const char*>(&number), sizeof number}); }
    void one(const std::string& text) { hash_.add(text); }
    template <typename Value, std::size_t count>
    void one(const std::array<Value, count>& values) { for (const Value& v : values) one(v); }
    template <typename Value>
    void one(const std::vector<Value>& values)
    {
        one(values.size());
        for (const Value& v : values) one(v);
    }
    template <typename Value>
    void one(const std::optional<Value>& value)
    {
        one(value.has_value());
        if (value) one(*value);
    }
    // The names bind every member of a struct: one that is added does not compile before it is folded in.
    void one(const api::Phase& p) { const auto& [type, g, values] = p; all(type, g, values); }
    void one(const api::Grid& grid) { const auto& [size, values, low, high] = grid; all(size, values, low, high); }
    void one(const api::Medium& m) { const auto& [name, sigma_t, albedo, phase, density] = m; all(name, sigma_t, albedo, phase, density); }
    void one(const api::Bsdf& b)
    {
        const auto& [name, type, reflectance, transmittance, eta, conductor_eta, conductor_k, alpha, ggx, two_sided, reflectance_texture, transmittance_texture, below,
                     below_texture, nonlinear] = b;
        all(name, type, reflectance, transmittance, eta, conductor_eta, conductor_k, alpha, ggx, two_sided, reflectance_texture, transmittance_texture, below, below_texture, nonlinear);
    }
    void one(const api::Mesh& m)
    {
        const auto& [name, vertices, normals, triangles, bsdf, interior, exterior, radiance, uvs] = m;
        all(name, vertices, normals, triangles, bsdf, interior, exterior, radiance, uvs);
    }
    void one(const api::Texture& t)
    {
        const auto& [name, type, width, height, channels, texels, filter, wrap, even, odd, to_uv] = t;
        all(name, type, width, height, channels, texels, filter, wrap, even, odd, to_uv);
    }
    void one(const api::EnvironmentMap& m) { const auto& [name, width, height, texels] = m; all(name, width, height, texels); }
    void one(const api::Emitter& e)
    {
        const auto& [name, type, value, position, direction, cutoff, beam, medium, map, up, middle] = e;
        all(name, type, value, position, direction, cutoff, beam, medium, map, up, middle);
    }
    void one(const api::Camera& c)
    {
        const auto& [origin, target, up, fov, near_clip, far_clip, width, height, box, medium] = c;
        all(origin, target, up, fov, near_clip, far_clip, width, height, box, medium);
    }

    SceneHash hash_;
};

}  // namespace

std::uint64_t hash_of(const api::SceneDescription& description)
{
    const auto& [name, media, bsdfs, meshes, emitters, camera, max_depth, textures, environment_maps] = description;
    Fold fold;
    fold.all(name, media, bsdfs, meshes, emitters, camera, max_depth, textures, environment_maps);
    return fold.value();
}

}  // namespace tyndall

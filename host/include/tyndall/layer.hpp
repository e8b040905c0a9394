#pragma once
/// The partition of all light (host/README.md): follow the camera path through delta and null interactions to its first scattering vertex x1;
/// x2 is the next vertex towards the light. The layers are disjoint and sum to the image. A path whose leg x1-x2 crosses a mirror or
/// refracting surface belongs to the `.specular` sub-layer, which connections through straight lines cannot carry.
#include <array>
#include <bitset>
#include <cstddef>
#include <string_view>

namespace tyndall {

enum class Layer : std::size_t {
    emitted,           ///< light seen directly or through media and specular surfaces
    surface_direct,    ///< x1 on a surface, x2 on a light
    surface_indirect,  ///< x1 and x2 on surfaces
    single,            ///< x1 in a medium, x2 on a light
    surface_to_media,  ///< x1 in a medium, x2 on a surface
    media_to_media,    ///< x1 and x2 in media
    media_to_surface,  ///< x1 on a surface, x2 in a medium
    surface_direct_specular,
    surface_indirect_specular,
    single_specular,
    surface_to_media_specular,
    media_to_media_specular,
    media_to_surface_specular,
};

inline constexpr std::size_t layer_count = 13;

inline constexpr std::array<std::string_view, layer_count> layer_names{
    "emitted",          "surface_direct",          "surface_indirect",          "single",          "surface_to_media",
    "media_to_media",   "media_to_surface",        "surface_direct.specular",   "surface_indirect.specular",
    "single.specular",  "surface_to_media.specular", "media_to_media.specular", "media_to_surface.specular"};

/// Name as it appears on the command line, in EXR channels and in the report.
constexpr std::string_view name(Layer layer) { return layer_names[static_cast<std::size_t>(layer)]; }

/// The sub-layer of paths whose leg x1-x2 crosses a specular surface; `emitted` has none.
constexpr Layer specular(Layer layer) { return static_cast<Layer>(static_cast<std::size_t>(layer) + 6); }

/// A set of layers.
class LayerSet {
public:
    constexpr LayerSet() = default;
    static LayerSet all() { LayerSet set; set.bits_.set(); return set; }
    bool contains(Layer layer) const { return bits_.test(static_cast<std::size_t>(layer)); }
    bool empty() const { return bits_.none(); }
    std::size_t size() const { return bits_.count(); }
    LayerSet& add(Layer layer) { bits_.set(static_cast<std::size_t>(layer)); return *this; }
    LayerSet& remove(Layer layer) { bits_.reset(static_cast<std::size_t>(layer)); return *this; }
    LayerSet without(const LayerSet& others) const { LayerSet left = *this; left.bits_ &= ~others.bits_; return left; }
    friend LayerSet operator&(LayerSet a, LayerSet b) { a.bits_ &= b.bits_; return a; }
    friend LayerSet operator|(LayerSet a, LayerSet b) { a.bits_ |= b.bits_; return a; }
    friend bool operator==(const LayerSet&, const LayerSet&) = default;

private:
    std::bitset<layer_count> bits_;
};

}  // namespace tyndall

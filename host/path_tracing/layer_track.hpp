#pragma once
/// Which layer a camera path belongs to, as it grows: by its first and second scattering vertex and by what lies between them
/// (tyndall/layer.hpp).
#include "tyndall/layer.hpp"

namespace tyndall {

class LayerTrack {
public:
    enum class Vertex { none, medium, surface };

    /// The path scatters, in a medium or diffusely at a surface.
    void scatter(Vertex vertex)
    {
        if (first_ == Vertex::none)
            first_ = vertex;
        else if (second_ == Vertex::none)
            second_ = vertex;
    }
    bool scattered() const { return first_ != Vertex::none; }
    bool scattered_twice() const { return second_ != Vertex::none; }
    /// The path is mirrored or refracted.
    void pass_specular() { specular_leg_ = specular_leg_ || (first_ != Vertex::none && second_ == Vertex::none); }

    /// The layer of light that is met now, or that a straight connection to a light finds from the last vertex.
    Layer of_light() const
    {
        if (first_ == Vertex::none) return Layer::emitted;
        const Layer layer = by_vertices[static_cast<std::size_t>(second_)][at_surface()];
        return specular_leg_ ? specular(layer) : layer;
    }
    /// The layers that the path can still add to.
    LayerSet reachable() const
    {
        if (first_ == Vertex::none) return LayerSet::all();
        LayerSet set;
        if (second_ != Vertex::none) return set.add(of_light());
        for (const auto& by_first : by_vertices) {
            const Layer layer = by_first[at_surface()];
            set.add(specular(layer));
            if (!specular_leg_) set.add(layer);
        }
        return set;
    }

private:
    bool at_surface() const { return first_ == Vertex::surface; }

    /// By second vertex (none: the light itself), then by first: medium, surface.
    static constexpr Layer by_vertices[3][2] = {{Layer::single, Layer::surface_direct},
                                                {Layer::media_to_media, Layer::media_to_surface},
                                                {Layer::surface_to_media, Layer::surface_indirect}};

    Vertex first_ = Vertex::none, second_ = Vertex::none;
    bool specular_leg_ = false;
};

}  // namespace tyndall

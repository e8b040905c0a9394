#pragma once
/// Transmittance and free flight along the pieces of a walked ray, in media of any kind (volumes/medium_line.hpp).
#include <span>

#include "scene/scene.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

/// The pieces of a walked ray, and the ray.
struct PieceView : std::span<const MediumPiece> {
    Vec3 origin{0}, direction{0, 0, 1};
    PieceView(const RayWalk& walk) : span(walk.pieces.data(), walk.pieces.size()), origin(walk.origin), direction(walk.direction) {}
    /// Along the z axis where nothing varies.
    PieceView(std::span<const MediumPiece> pieces) : span(pieces) {}
    PieceView(std::span<const MediumPiece> pieces, const Vec3& from, const Vec3& along) : span(pieces), origin(from), direction(along) {}
};

/// What happened to light on its way along the pieces.
struct FreeFlight {
    bool collided = false;  ///< it met a particle at distance t in pieces[piece]; otherwise it passed through all of them
    std::size_t piece = 0;
    double t = 0;
    Rgb weight{
        0};  ///< collided: sigma_s x transmittance / density; passed: transmittance / probability. 0 in channels where `throughput` is 0
};

/// Optical depth per channel of all pieces together. A piece may be 1e30 long: the depth is then huge but finite.
Rgb optical_depth_of(const Scene& scene, PieceView pieces);
Rgb transmittance_of(const Scene& scene, PieceView pieces);

/// Optical depth per channel from the start of the first piece to distance t in pieces[piece].
Rgb optical_depth_to(const Scene& scene, PieceView pieces, std::size_t piece, double t);

/// Free flight, by regular tracking in grids: exact for any extinction. xi.x chooses a channel in proportion to `throughput`, xi.y the optical depth there; the density is balanced over channels,
/// so that throughput x weight never exceeds the throughput's sum over channels (x albedo).
FreeFlight sample_free_flight(const Scene& scene, PieceView pieces, const Rgb& throughput, const Vec2& xi);

/// Distance in [0, length] with density proportional to exp(-sigma t), by -log1p(xi expm1(-sigma length)) / sigma; length may be infinite
/// if sigma > 0.
double sample_exponential(double sigma, double length, double xi);

/// Its density per length at t.
double pdf_exponential(double sigma, double length, double t);

}  // namespace tyndall

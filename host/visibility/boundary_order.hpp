#pragma once
/// In which order a ray crosses the null boundaries that it meets.
#include <boost/container/small_vector.hpp>

#include "visibility/visibility.hpp"

namespace tyndall {

/// One meeting of a ray with a null surface that bounds a medium.
struct Crossing {
    double t;
    double cosine;  ///< |direction . geometric normal|
    int shape;
    int from, to;  ///< the media on the two sides, in the ray's sense
};

using Crossings = boost::container::small_vector<Crossing, 16>;
using MediumPieces = decltype(RayWalk::pieces);

/// Where the part of a ray that is walked begins and ends, and whether a surface that is not null ends it.
struct WalkedPart {
    double t0, t1;
    bool at_surface;
};

/// Cuts `part` at the crossings (sorted here by t) into pieces, beginning in `medium`; returns the medium of the last piece.
///
/// Boundaries that coincide (closer than `Visibility::endpoint_rounding`, measured along the normal) are crossed so that media match: among
/// those not yet crossed, one whose `from` is the current medium; otherwise the nearest, unless the same side of the same shape was crossed
/// just now (the ray met an edge between two triangles). A boundary that lies on the surface at the end (closer than
/// `Visibility::surface_offset`) is not crossed: a ray that leaves the surface starts beyond it.
int cut_at_boundaries(Crossings& crossings, const WalkedPart& part, int medium, MediumPieces& pieces);

}  // namespace tyndall

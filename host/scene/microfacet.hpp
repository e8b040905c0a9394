#pragma once
/// The facets of rough surfaces: how their normals are distributed, how many of them a direction sees, and how they are drawn. Local frame: +z is the surface's normal,
/// x runs along dp/du. [Walter et al. 2007; Heitz 2014]
#include "scene/scene.hpp"

namespace tyndall {

/// Area of facets per area of surface and steradian of their normal h; 0 where h points down. Its integral times h.z is 1.
double facet_density(const Roughness& roughness, const Vec3& h);

/// Smith's G1(w) / |w.z|: the share of facets that is seen from w, over the cosine. Finite down to w.z = 0. The same on both sides of the surface.
double seen_over_cosine(const Roughness& roughness, const Vec3& w);

/// G1(w): 1 from above, 0 edge-on.
double seen_share(const Roughness& roughness, const Vec3& w);

/// Density per steradian of the normals that w (w.z > 0) sees: G1(w) max(w.h, 0) D(h) / w.z. Integrates to 1.
double pdf_seen_facet(const Roughness& roughness, const Vec3& w, const Vec3& h);

/// A normal of that density. GGX: a point of the spherical cap around w [Dupuy and Benyoub 2023]. Beckmann: the slope along w by inverting its distribution, that across
/// is Gaussian [Heitz and d'Eon 2014].
Vec3 sample_seen_facet(const Roughness& roughness, const Vec3& w, const Vec2& xi);

/// Share of light from w (w.z > 0) that facets with a boundary of relative index eta reflect, once: the integral of F D G1 G1 / (4 w.z) over directions.
double facet_reflectance(const Roughness& roughness, double cosine, double eta);

}  // namespace tyndall

/// The one list of what a scene may call for. Read as build option (-DFEATURES=mask), host bits, C++ constants, report lines and documentation.
/// Kernels say `if (ANISOTROPIC)`, never #ifdef: a feature removes work, it never changes a record.
#ifndef SCENE_FEATURES_H
#define SCENE_FEATURES_H

/// F(name, bit, what it means)
#define SCENE_FEATURES(F)                                                                                        \
    F(ANISOTROPIC, 0, "a medium scatters with a phase function that is not isotropic")                          \
    F(COLOURED, 1, "the extinction of a medium differs between channels")                                       \
    F(OCCLUDERS, 2, "something can stand between the two ends of a connection: shadow segments are traced")     \
    F(MANY_MEDIA, 3, "there is more than one medium")                                                           \
    F(BOUNDARIES, 4, "a connection may cross the boundary of a medium")                                         \
    F(NONCONVEX_MEDIA, 5, "boundaries are not disjoint convex polyhedra: crossing connections are walked on the host") \
    F(SHORT_LIGHTS, 6, "virtual ray lights end at their sampled collision")                                     \
    F(DEPTH_LIMIT, 7, "paths are limited in length")                                                           \
    F(PHASE_LOBES, 8, "a phase function is neither isotropic nor Henyey and Greenstein's")                     \
    F(HETEROGENEOUS, 9, "a medium's extinction or albedo comes from a grid")                                   \
    F(COLOURED_GRIDS, 10, "a grid of extinction has three channels")

#ifndef FEATURES
#define FEATURES 0xffffffffu
#endif

#define SCENE_FEATURE_CONSTANT(name, bit, text) name = (FEATURES >> bit) & 1u,
enum { SCENE_FEATURES(SCENE_FEATURE_CONSTANT) SCENE_FEATURES_END };
#undef SCENE_FEATURE_CONSTANT

#endif

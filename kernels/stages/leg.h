// Where a connection runs inside media: through the only one, or through containers.
#ifndef LEG_H
#define LEG_H

#define MOST_PLANES 64     // of a container (host/scene/containers.cpp)

/// Part of the segment from + t d, 0 <= t <= 1, that lies inside the container.
PURE ClipInterval chord(__global const PlaneRecord* planes, ContainerRecord container, real3 from, real3 d)
{
    ClipInterval inside = {R(0.0), R(1.0)};
    for (uint i = 0; i < container.plane_count; ++i) {
        PlaneRecord plane = planes[container.first_plane + i];
        real3 n = make_real3((real)plane.normal_x, (real)plane.normal_y, (real)plane.normal_z);
        inside = clip_half_space(inside.enter, inside.leave, (real)plane.offset - dot3(n, from), dot3(n, d));
    }
    return inside;
}

/// The planes of the only container that some eye of the group is outside of, with the distance of each eye beyond them. Only they can
/// cut a connection to a light in the medium, which lies inside.
typedef struct {
    uint count;
    uint plane[MOST_PLANES];
    real outside[MOST_PLANES];  ///< distance of the eye beyond the plane, 0 if inside
} FacingPlanes;

PURE void find_facing_planes(FacingPlanes* facing, Surroundings s, real3 from)
{
    facing->count = 0;
    if (!BOUNDARIES) return;
    if (NONCONVEX_MEDIA || s.container_count != 1u) return;
    if (LIGHT_ON_SURFACE) return;
    ContainerRecord container = s.containers[0];
    for (uint i = 0; i < container.plane_count; ++i) {
        PlaneRecord plane = s.planes[container.first_plane + i];
        real3 n = make_real3((real)plane.normal_x, (real)plane.normal_y, (real)plane.normal_z);
        real outside = fmax(dot3(n, from) - (real)plane.offset, R(0.0));
        if (!any_lane(outside > R(0.0))) continue;
        facing->plane[facing->count] = container.first_plane + i;
        facing->outside[facing->count] = outside;
        ++facing->count;
    }
}

/// Where the connection from + t d enters the only container: where the last facing plane is crossed. The largest of the ratios
/// outside / approach is found by cross-multiplication; approach >= outside because the light lies inside (so the ratio is at most 1, also after rounding).
PURE real enters_container(const FacingPlanes* facing, Surroundings s, real3 d)
{
    real most = R(0.0), over = R(1.0);
    for (uint i = 0; i < facing->count; ++i) {
        PlaneRecord plane = s.planes[facing->plane[i]];
        real3 n = make_real3((real)plane.normal_x, (real)plane.normal_y, (real)plane.normal_z);
        real outside = facing->outside[i], approach = fmax(-dot3(n, d), outside);
        mask later = outside * over > most * approach;
        most = select(most, outside, later), over = select(over, approach, later);
    }
    return most / over;
}

/// A connection from + t d, 0 <= t <= 1, and how to integrate grids along it.
typedef struct {
    real3 from, d;
    real length;   ///< |d|
    MarchShift shift;  ///< of a march
    uint exact;        ///< 1: cell by cell
} Leg;

/// Optical depth of the part enter <= t <= leave in one medium.
PURE real3 piece_depth(Surroundings s, MediumRecord medium, Leg leg, real enter, real leave)
{
    real3 sigma = make_real3((real)medium.sigma_t_r, (real)medium.sigma_t_g, (real)medium.sigma_t_b);
    if (!HETEROGENEOUS) return scale3(sigma, fmax(leave - enter, R(0.0)) * leg.length);
    if (TRANSMITTANCE == TRANSMITTANCE_EXACT || leg.exact) return mul3(sigma, exact_path(s, medium, leg.from, leg.d, leg.length, enter, leave));
    return mul3(sigma, marched_path(s, medium, leg.from, leg.d, leg.length, enter, leave, leg.shift));
}

/// Optical depth of a connection to a light in `medium`, where it follows from the records; NONCONVEX_MEDIA leaves it to the host.
PURE real3 leg_depth(const FacingPlanes* facing, Surroundings s, MediumRecord medium, Leg leg)
{
    real3 depth = make_real3(R(0.0), R(0.0), R(0.0));
    if (NONCONVEX_MEDIA) return depth;
    if (!BOUNDARIES || s.container_count == 0u) return piece_depth(s, medium, leg, R(0.0), R(1.0));
    if (!LIGHT_ON_SURFACE && s.container_count == 1u) return piece_depth(s, medium, leg, enters_container(facing, s, leg.d), R(1.0));
    for (uint i = 0; i < s.container_count; ++i) {
        ContainerRecord container = s.containers[i];
        ClipInterval inside = chord(s.planes, container, leg.from, leg.d);
        depth = add3(depth, piece_depth(s, s.media[container.medium], leg, inside.enter, inside.leave));
    }
    return depth;
}

#endif

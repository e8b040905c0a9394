// Loads and helpers that every stage of the pair pipeline shares.
#ifndef CONNECTION_H
#define CONNECTION_H

#define MOST_PLANES 64     // of a container (host/scene/containers.cpp)
#define LIGHT_BLOCK 256u  // lights are summed in fixed blocks of so many, by light number

/// Length of the part of the segment from + t d, 0 <= t <= 1, |d| = length, that lies inside the container.
static inline real chord(__global const PlaneRecord* planes, ContainerRecord container, real3 from, real3 d, real length)
{
    real enter = R(0.0), leave = R(1.0);
    for (uint i = 0; i < container.plane_count; ++i) {
        PlaneRecord plane = planes[container.first_plane + i];
        real3 n = make_real3((real)plane.normal_x, (real)plane.normal_y, (real)plane.normal_z);
        ClipInterval clipped = clip_half_space(enter, leave, (real)plane.offset - dot3(n, from), dot3(n, d));
        enter = clipped.enter, leave = clipped.leave;
    }
    return fmax(leave - enter, R(0.0)) * length;
}

/// The planes of the only container that some eye of the group is outside of, with the distance of each eye beyond them. Only they can
/// cut a connection to a light, which lies inside.
typedef struct {
    uint count;
    uint plane[MOST_PLANES];
    real outside[MOST_PLANES];  ///< distance of the eye beyond the plane, 0 if inside
} FacingPlanes;

static inline void find_facing_planes(FacingPlanes* facing, Surroundings s, real3 from)
{
    facing->count = 0;
    if (!BOUNDARIES) return;
    if (NONCONVEX_MEDIA || s.container_count != 1u) return;
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

/// Length of the connection inside the only container: from where the last facing plane is crossed to the light. The largest of the ratios
/// outside / approach is found by cross-multiplication; approach >= outside because the light lies inside (so the ratio is at most 1, also after rounding).
static inline real inner_length(const FacingPlanes* facing, Surroundings s, real3 d, real length)
{
    real most = R(0.0), over = R(1.0);
    for (uint i = 0; i < facing->count; ++i) {
        PlaneRecord plane = s.planes[facing->plane[i]];
        real3 n = make_real3((real)plane.normal_x, (real)plane.normal_y, (real)plane.normal_z);
        real outside = facing->outside[i], approach = fmax(-dot3(n, d), outside);
        mask later = outside * over > most * approach;
        most = select(most, outside, later), over = select(over, approach, later);
    }
    return (R(1.0) - most / over) * length;
}

/// Transmittance of the connection itself, where it follows from the records; NONCONVEX_MEDIA leaves it to the host.
static inline real3 leg_transmittance(const FacingPlanes* facing, Surroundings s, MediumRecord medium, Connection c)
{
    if (NONCONVEX_MEDIA) return make_real3(R(1.0), R(1.0), R(1.0));
    real3 sigma = make_real3((real)medium.sigma_t_r, (real)medium.sigma_t_g, (real)medium.sigma_t_b);
    if (!BOUNDARIES || s.container_count == 0u) return transmittance3(scale3(sigma, c.length));
    real3 depth = make_real3(R(0.0), R(0.0), R(0.0)), d = sub3(c.to, c.from);
    if (s.container_count == 1u) return transmittance3(scale3(sigma, inner_length(facing, s, d, c.length)));
    for (uint i = 0; i < s.container_count; ++i) {
        ContainerRecord container = s.containers[i];
        MediumRecord inside = s.media[container.medium];
        real inner = chord(s.planes, container, c.from, d, c.length);
        depth = along3(depth, R(1.0), scale3(make_real3((real)inside.sigma_t_r, (real)inside.sigma_t_g, (real)inside.sigma_t_b), inner));
    }
    return transmittance3(depth);
}

/// Pairs that are taken through one step together: the steps of one pair depend on each other, the same step of several pairs does not, and a processor
/// that executes out of order fills the waits of one with the others (bench: 1.4 times the pairs per second of one pair after another). Devices that hide
/// waits by threads take one at a time.
enum { PAIR_BATCH = LANES == 1 ? 1 : 8 };

static inline MediumRecord medium_of(Surroundings s, Light light) { return s.media[MANY_MEDIA ? light.medium : 0u]; }

/// Where `count` <= PAIR_BATCH connections run, of the pairs with the numbers counter, counter + 1, ...: number / samples is the light.
static inline void place_pairs(OnBoth* places, Eye eye, __global const Light* lights, Surroundings s, uint counter, uint count, uint samples)
{
    OnLight on_light[PAIR_BATCH];
    real second[PAIR_BATCH];
    for (uint i = 0; i < count; ++i) {
        Random2 xi = random2(eye.key, counter + i);
        on_light[i] = place_light(eye, lights[(counter + i) / samples], xi.first);
        second[i] = xi.second;
    }
    for (uint i = 0; i < count; ++i) {
        Light light = lights[(counter + i) / samples];
        places[i] = place_eye(eye, light, medium_of(s, light), on_light[i], second[i]);
    }
}

/// One sample of one light for LANES eyes, with everything but visibility. Radiance that is not finite is counted in the ledger (0: how many, 1 and 2: the
/// first eye and counter) and taken out of the sum; pairs under the floor are counted (3) and stay.
static inline Connection connect_counted(Eye eye, const FacingPlanes* facing, Light light, Surroundings s, OnBoth at, uint vertex_limit, uint counter,
                                         __global uint* ledger, uint group)
{
    MediumRecord medium = medium_of(s, light);
    Connection c = connect_eye(eye, light, medium, at);
    c.radiance = mul3(c.radiance, leg_transmittance(facing, s, medium, c));
    if (DEPTH_LIMIT) {
        mask allowed = to_mask(eye.depth + light.depth + 2u <= vertex_limit);
        c.radiance = select3(make_real3(R(0.0), R(0.0), R(0.0)), c.radiance, allowed);
    }
    if (any_lane(c.floored)) atomic_add(&ledger[3], count_lanes(c.floored));
    mask finite = to_mask(isfinite(c.radiance.x + c.radiance.y + c.radiance.z));
    if (!all_lanes(finite)) {
        uint lanes = count_lanes(finite);
        if (atomic_add(&ledger[0], LANES - lanes) == 0u) ledger[1] = group * LANES, ledger[2] = counter;
        c.radiance = select3(make_real3(R(0.0), R(0.0), R(0.0)), c.radiance, finite);
    }
    return c;
}

/// Running sums of one group: for c = r, g, b the lanes of `high`, then of `low`.
typedef struct { LongSum r, g, b; } LongSum3;
static inline LongSum3 load_sums(__global const float* sums, uint group)
{
    LongSum3 s;
    s.r.high = load_lanes(sums, group * 6u), s.r.low = load_lanes(sums, group * 6u + 1u);
    s.g.high = load_lanes(sums, group * 6u + 2u), s.g.low = load_lanes(sums, group * 6u + 3u);
    s.b.high = load_lanes(sums, group * 6u + 4u), s.b.low = load_lanes(sums, group * 6u + 5u);
    return s;
}
static inline void store_sums(LongSum3 s, __global float* sums, uint group)
{
    store_lanes(s.r.high, group * 6u, sums), store_lanes(s.r.low, group * 6u + 1u, sums);
    store_lanes(s.g.high, group * 6u + 2u, sums), store_lanes(s.g.low, group * 6u + 3u, sums);
    store_lanes(s.b.high, group * 6u + 4u, sums), store_lanes(s.b.low, group * 6u + 5u, sums);
}
static inline LongSum3 add_block(LongSum3 s, real3 x)
{
    s.r = add_to(s.r, x.x), s.g = add_to(s.g, x.y), s.b = add_to(s.b, x.z);
    return s;
}

#endif

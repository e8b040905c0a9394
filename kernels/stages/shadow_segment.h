// Writing shadow segments for the host.
#ifndef SHADOW_SEGMENT_H
#define SHADOW_SEGMENT_H

/// Rounding of a point in render space, |x| <= 1: both ends of a segment are shortened by it (the host's Visibility::endpoint_rounding, tested equal).
#define ENDPOINT_ROUNDING R(4.76837158e-7)

/// Lanes that carry nothing, or whose ends are closer than their rounding, or that are not finite, are not asked: tfar = -1 (counts as visible: their
/// contribution is what it is). So Embree never sees a coordinate that is not finite.
PURE void store_shadow_segment(Connection c, __global ShadowPacket* packet, uint offset)
{
    real3 d = sub3(c.to, c.from), zero = make_real3(R(0.0), R(0.0), R(0.0));
    real margin = ENDPOINT_ROUNDING / c.length;
    mask ask = (fabs(c.radiance.x) + fabs(c.radiance.y) + fabs(c.radiance.z) > R(0.0)) & (margin < R(0.5)) & to_mask(isfinite(d.x + d.y + d.z + c.from.x + c.from.y + c.from.z));
    real3 from = select3(zero, c.from, ask);
    d = select3(make_real3(R(0.0), R(0.0), R(1.0)), d, ask);
    store_lanes(from.x, 0, packet->origin_x + offset), store_lanes(from.y, 0, packet->origin_y + offset), store_lanes(from.z, 0, packet->origin_z + offset);
    store_lanes(d.x, 0, packet->direction_x + offset), store_lanes(d.y, 0, packet->direction_y + offset), store_lanes(d.z, 0, packet->direction_z + offset);
    store_lanes(select(R(0.0), margin, ask), 0, packet->tnear + offset);
    store_lanes(R(0.0), 0, packet->time + offset);
    store_lanes(select(R(-1.0), R(1.0) - margin, ask), 0, packet->tfar + offset);
    store_floats((bits)(0xffffffffu), 0, packet->mask + offset);
    store_floats((bits)(0u), 0, packet->id + offset);
    store_floats((bits)(0u), 0, packet->flags + offset);
}

#endif

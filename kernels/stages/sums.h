// What eyes receive, added up.
#ifndef SUMS_H
#define SUMS_H

#define LIGHT_BLOCK 256u  // lights are summed in fixed blocks of so many, by light number

/// The largest contribution to each eye so far, as the sum of its channels, and the counter of its pair. It changes no sum: what one pair is worth is told, not cut.
typedef struct { real value; bits counter; } Worst;
PURE Worst no_worst(void)
{
    Worst w = {R(0.0), (bits)(0u)};
    return w;
}
PURE Worst worse(Worst w, real3 radiance, bits counter)
{
    real value = radiance.x + radiance.y + radiance.z;
    mask larger = value > w.value;
    Worst r = {select(w.value, value, larger), select_bits(w.counter, counter, larger)};
    return r;
}
PURE void keep_worst(Worst w, uint group, __global float* worst, __global uint* worst_counters)
{
    real before = load_lanes(worst, group);
    mask larger = w.value > before;
    if (!any_lane(larger)) return;
    store_lanes(select(before, w.value, larger), group, worst);
    store_bits(select_bits(load_bits(worst_counters, group), w.counter, larger), group, worst_counters);
}

/// Running sums of one group: for c = r, g, b the lanes of `high`, then of `low`.
typedef struct { LongSum r, g, b; } LongSum3;
PURE LongSum3 load_sums(__global const float* sums, uint group)
{
    LongSum3 s;
    s.r.high = load_lanes(sums, group * 6u), s.r.low = load_lanes(sums, group * 6u + 1u);
    s.g.high = load_lanes(sums, group * 6u + 2u), s.g.low = load_lanes(sums, group * 6u + 3u);
    s.b.high = load_lanes(sums, group * 6u + 4u), s.b.low = load_lanes(sums, group * 6u + 5u);
    return s;
}
PURE void store_sums(LongSum3 s, __global float* sums, uint group)
{
    store_lanes(s.r.high, group * 6u, sums), store_lanes(s.r.low, group * 6u + 1u, sums);
    store_lanes(s.g.high, group * 6u + 2u, sums), store_lanes(s.g.low, group * 6u + 3u, sums);
    store_lanes(s.b.high, group * 6u + 4u, sums), store_lanes(s.b.low, group * 6u + 5u, sums);
}
PURE LongSum3 add_block(LongSum3 s, real3 x)
{
    s.r = add_to(s.r, x.x), s.g = add_to(s.g, x.y), s.b = add_to(s.b, x.z);
    return s;
}

#endif

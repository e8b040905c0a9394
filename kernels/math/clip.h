/// Clipping a segment against half-spaces.
#ifndef CLIP_H
#define CLIP_H

typedef struct { real enter, leave; } ClipInterval;

/// Part of [enter, leave] where room - slope t >= 0: `room` is the distance of the segment's start to the plane, measured inwards, `slope` the outward
/// speed. slope = 0: everything or nothing. An empty interval has leave < enter.
PURE ClipInterval clip_half_space(real enter, real leave, real room, real slope)
{
    real t = room / slope;                                   // slope = 0 gives infinity or NaN, which no select below takes
    ClipInterval c;
    c.leave = select(leave, fmin(leave, t), slope > R(0.0));
    c.enter = select(enter, fmax(enter, t), slope < R(0.0));
    c.leave = select(c.leave, R(-1.0), (slope == R(0.0)) & (room < R(0.0)));
    return c;
}

#endif

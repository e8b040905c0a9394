/// A density that is linear between two values: the piece of a piecewise-linear density.
#ifndef LINEAR_PIECE_H
#define LINEAR_PIECE_H

#include "kernels/dialect.h"

/// Position in [0, 1] with density proportional to lerp(f0, f1, r), f0, f1 >= 0 (eq. 26); uniform if both are 0. No cancellation. xi in [0, 1).
PURE real sample_linear(real f0, real f1, real xi)
{
    real largest = fmax(f0, f1), scale = R(1.0) / fmax(largest, REAL_SMALLEST);
    mask flat = largest < REAL_SMALLEST;
    real g0 = select(f0 * scale, R(1.0), flat), g1 = select(f1 * scale, R(1.0), flat);
    real root = sqrt(fma(xi, g1 * g1, (R(1.0) - xi) * (g0 * g0)));
    return fmin(xi * (g0 + g1) / fmax(g0 + root, REAL_SMALLEST), R(1.0));
}

/// Density of sample_linear at r in [0, 1].
PURE real pdf_linear(real f0, real f1, real r)
{
    real sum = f0 + f1;
    mask flat = fmax(f0, f1) < REAL_SMALLEST;
    return select(R(2.0) * fma(r, f1, (R(1.0) - r) * f0) / select(sum, R(1.0), flat), R(1.0), flat);
}

/// The xi for which sample_linear returns r.
PURE real invert_linear(real f0, real f1, real r)
{
    real sum = f0 + f1;
    mask flat = fmax(f0, f1) < REAL_SMALLEST;
    return select(r * fma(r, f1, (R(2.0) - r) * f0) / select(sum, R(1.0), flat), r, flat);
}

#endif

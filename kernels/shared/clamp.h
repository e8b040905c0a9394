/// Build option (-DCLAMP=x, a float): the geometry term 1 / w^2 of a connection is at most x, per square of render space's unit; 0: it is what it is.
#ifndef CLAMP_H
#define CLAMP_H

#ifndef CLAMP
#define CLAMP 0.0f
#endif
#define CLAMPS (CLAMP > 0.0f)

/// Sums that every eye has: of what arrives and, with a clamp, of what it took away.
#define SUMS_OF_EYE (CLAMPS ? 2u : 1u)

#endif

#pragma once
/// Closed forms in 50 digits, from the exact values of the inputs. They share no code with kernels/ and may cancel as much as they like.
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace tyndall::test {

using Big = boost::multiprecision::cpp_bin_float_50;

struct Big3 {
    Big x, y, z;
};
inline Big3 operator+(const Big3& a, const Big3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Big3 operator-(const Big3& a, const Big3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Big3 operator*(const Big& t, const Big3& a) { return {t * a.x, t * a.y, t * a.z}; }
inline Big dot(const Big3& a, const Big3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Big3 cross(const Big3& a, const Big3& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Big length(const Big3& a) { return sqrt(dot(a, a)); }
inline Big3 unit(const Big3& a) { return Big(1 / length(a)) * a; }
inline Big clamp(const Big& x, const Big& low, const Big& high) { return x < low ? low : x > high ? high : x; }

/// Light q + v b, 0 <= v <= L, and the line along a through the origin.
struct RodOracle {
    Big s, D0, D1, h, beta, L, potential;

    RodOracle(const Big3& q, const Big3& a, const Big3& b, const Big& light_length) : L(light_length)
    {
        const Big3 n = cross(b, a), m = cross(q, a), m1 = m + L * n;
        s = length(n), D0 = length(m), D1 = length(m1), beta = dot(m, n);
        h = s == 0 ? D0 : Big(length(cross(m, n)) / s);
        potential = s == 0 ? Big(L / D0) : Big(2 / s * atanh(s * L / (D0 + D1)));
    }
    /// Smallest distance of the light to the line.
    Big nearest() const { return beta < 0 && beta + s * s * L > 0 ? h : D0 < D1 ? D0 : D1; }
    /// The v below which the share xi of the integral of 1 / D lies.
    Big position(const Big& xi) const
    {
        if (s == 0) return xi * L;
        const Big y = xi * potential * s, half = sinh(y / 2);
        return D0 / s * sinh(y) + beta / (s * s) * 2 * half * half;
    }
};

/// Segment u a, 0 <= u <= S, seen from p.
struct AngleOracle {
    Big D, t0, t1, S, angle, over_distance;

    AngleOracle(const Big3& p, const Big3& a, const Big& segment_length) : S(segment_length)
    {
        D = length(cross(p, a)), t0 = -dot(p, a), t1 = S + t0;
        angle = atan2(Big(D * S), Big(D * D + t0 * t1));
        over_distance = D == 0 ? Big(1 / t0 - 1 / t1) : Big(angle / D);
    }
    Big position(const Big& xi) const
    {
        if (D == 0) return t0 * xi * S / (t1 - xi * S);
        const Big psi = xi * angle;
        return (D * D + t0 * t0) * sin(psi) / (D * cos(psi) - t0 * sin(psi));
    }
};

/// F of the closed form for parallel segments at the distance h.
inline Big parallel_primitive(const Big& z, const Big& h) { return z / h * atan(Big(z / h)) - log(Big(h * h + z * z)) / 2; }

/// Integral of dv du / w^2 over parallel segments [u0, u1], [v0, v1] (positions on a common axis).
inline Big parallel_integral(const Big& u0, const Big& u1, const Big& v0, const Big& v1, const Big& h)
{
    return parallel_primitive(u1 - v0, h) + parallel_primitive(u0 - v1, h) - parallel_primitive(u1 - v1, h) - parallel_primitive(u0 - v0, h);
}

/// Integral of (n . omega) / w^2 over the light p + v b, a <= v <= e, seen from the origin; signed.
inline Big surface_primitive(const Big3& p, const Big3& b, const Big3& n, const Big& v)
{
    const Big foot = dot(p, b), t = v + foot;
    const Big3 f = p - foot * b;
    const Big D2 = dot(f, f), w = sqrt(Big(D2 + t * t));
    return (D2 == 0 ? Big(0) : Big(dot(n, f) * t / (D2 * w))) - dot(n, b) / w;
}

}  // namespace tyndall::test

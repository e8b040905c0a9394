#include "transport/medium.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall {
namespace {

Rgb depth_of(const Scene& scene, const MediumPiece& piece, double t)
{
    return piece.medium == vacuum ? Rgb(0) : (t - piece.t0) * scene.media[piece.medium].sigma_t;
}

/// exp(-depth) / sum_c share_c exp(-depth_c) x factor_c, per channel; the least depth is taken out first, so that nothing underflows to
/// 0/0.
Rgb balanced(const Rgb& share, const Rgb& depth, const Rgb& factor)
{
    double least = 1e300;
    for (int c = 0; c < 3; ++c)
        if (share[c] * factor[c] > 0) least = std::min(least, depth[c]);
    Rgb relative(0);
    for (int c = 0; c < 3; ++c)
        if (share[c] > 0) relative[c] = std::exp(std::min(least - depth[c], 700.0));  // above the least only where factor is 0
    return relative / sum(share * factor * relative);
}

int choose_channel(const Rgb& share, double xi)
{
    int chosen = share.x > 0 ? 0 : share.y > 0 ? 1 : 2;
    for (int c = chosen; c < 3; ++c) {
        if (share[c] > 0) chosen = c;
        if (xi < share[c]) break;
        xi -= share[c];
    }
    return chosen;
}

}  // namespace

Rgb optical_depth_of(const Scene& scene, PieceView pieces)
{
    Rgb depth(0);
    for (const MediumPiece& piece : pieces) depth += depth_of(scene, piece, piece.t1);
    return depth;
}

Rgb transmittance_of(const Scene& scene, PieceView pieces) { return glm::exp(-optical_depth_of(scene, pieces)); }

Rgb optical_depth_to(const Scene& scene, PieceView pieces, std::size_t piece, double t)
{
    return optical_depth_of(scene, pieces.first(piece)) + depth_of(scene, pieces[piece], t);
}

FreeFlight sample_free_flight(const Scene& scene, PieceView pieces, const Rgb& throughput, const Vec2& xi)
{
    const double total = sum(throughput);
    if (!(total > 0)) return {};
    const Rgb share = throughput / total;
    const int channel = choose_channel(share, xi.x);
    double left = -std::log1p(-xi.y);  // optical depth still to go, in the chosen channel
    Rgb depth(0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const MediumPiece& piece = pieces[i];
        const Rgb through = depth_of(scene, piece, piece.t1);
        if (left < through[channel]) {
            const Medium& medium = scene.media[piece.medium];
            const double t = std::min(piece.t0 + left / medium.sigma_t[channel], piece.t1);
            const Rgb weight = medium.sigma_s() * balanced(share, depth + depth_of(scene, piece, t), medium.sigma_t);
            return {.collided = true, .piece = i, .t = t, .weight = weight};
        }
        left -= through[channel];
        depth += through;
    }
    return {.weight = balanced(share, depth, Rgb(1))};
}

double sample_exponential(double sigma, double length, double xi)
{
    const double depth = sigma * length;
    if (depth < 1e-14) return xi * length;  // the next term of the series is below the rounding of double
    return std::min(-std::log1p(xi * std::expm1(-depth)) / sigma, length);
}

double pdf_exponential(double sigma, double length, double t)
{
    const double depth = sigma * length;
    if (depth < 1e-14) return 1 / length;
    return sigma * std::exp(-sigma * t) / -std::expm1(-depth);
}

}  // namespace tyndall

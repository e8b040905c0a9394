#include "transport/medium.hpp"

#include <algorithm>
#include <cmath>

#include "volumes/medium_line.hpp"

namespace tyndall {
namespace {

MediumLine line_of(const Scene& scene, const PieceView& pieces, const MediumPiece& piece, double t)
{
    return {.medium = scene.media[piece.medium], .origin = pieces.origin, .direction = pieces.direction, .t0 = piece.t0, .t1 = t};
}

Rgb depth_of(const Scene& scene, const PieceView& pieces, const MediumPiece& piece, double t)
{
    return piece.medium == vacuum ? Rgb(0) : optical_depth(scene, line_of(scene, pieces, piece, t));
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
    for (const MediumPiece& piece : pieces) depth += depth_of(scene, pieces, piece, piece.t1);
    return depth;
}

Rgb transmittance_of(const Scene& scene, PieceView pieces) { return glm::exp(-optical_depth_of(scene, pieces)); }

Rgb optical_depth_to(const Scene& scene, PieceView pieces, std::size_t piece, double t)
{
    return optical_depth_of(scene, PieceView(pieces.first(piece), pieces.origin, pieces.direction)) + depth_of(scene, pieces, pieces[piece], t);
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
        if (piece.medium == vacuum) continue;
        const DepthReached end = reach_depth(scene, line_of(scene, pieces, piece, piece.t1), channel, left);
        depth += end.depth;
        if (end.reached) {
            const MediumPoint at = medium_at(scene, scene.media[piece.medium], pieces.origin + end.t * pieces.direction);
            // A grid is 0 there with probability 0, so only after rounding.
            if (!(sum(share * at.sigma_t) > 0)) return {};
            return {.collided = true, .piece = i, .t = end.t, .weight = at.sigma_s() * balanced(share, depth, at.sigma_t)};
        }
        left -= end.depth[channel];
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

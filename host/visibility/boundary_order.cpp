#include "visibility/boundary_order.hpp"

#include <algorithm>
#include <span>

namespace tyndall {
namespace {

/// Below this cosine two boundaries no longer count as one because the ray grazes them: bounds the stretch along the ray to 2^-10.
constexpr double least_cosine = 0x1p-10;

bool coincide(double t, double t_after, double cosine, double tolerance)
{
    return (t_after - t) * std::max(cosine, least_cosine) <= tolerance * std::max(1.0, t);
}

bool same_side(const Crossing& a, const Crossing& b) { return a.shape == b.shape && a.from == b.from && a.to == b.to; }

/// The end of the group of coincident boundaries that begins at `first`.
std::size_t group_end(const Crossings& crossings, std::size_t first)
{
    const auto& start = crossings[first];
    std::size_t end = first + 1;
    while (end < crossings.size() &&
           coincide(start.t, crossings[end].t, std::max(start.cosine, crossings[end].cosine), Visibility::endpoint_rounding))
        ++end;
    return end;
}

/// Moves the next boundary to cross to group[0]; `crossed` are those of this group that were crossed already.
void bring_next_forward(std::span<Crossing> group, std::span<const Crossing> crossed, int medium)
{
    auto next = std::find_if(group.begin(), group.end(), [&](const Crossing& c) { return c.from == medium; });
    if (next == group.end())
        next = std::find_if(group.begin(), group.end(), [&](const Crossing& c) {
            return std::none_of(crossed.begin(), crossed.end(), [&](const Crossing& done) { return same_side(done, c); });
        });
    if (next != group.end()) std::rotate(group.begin(), next, next + 1);
}

class PieceCutter {
public:
    PieceCutter(double t0, int medium, MediumPieces& pieces) : t_(t0), medium_(medium), pieces_(pieces) {}

    void cross(const Crossing& c)
    {
        if (c.to == medium_) return;
        finish_piece(c.t);
        medium_ = c.to;
    }
    void finish_piece(double t)
    {
        if (t <= t_) return;
        pieces_.push_back({medium_, t_, t});
        t_ = t;
    }
    int medium() const { return medium_; }

private:
    double t_;
    int medium_;
    MediumPieces& pieces_;
};

}  // namespace

int cut_at_boundaries(Crossings& crossings, const WalkedPart& part, int medium, MediumPieces& pieces)
{
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    if (part.at_surface)
        crossings.erase(std::remove_if(crossings.begin(), crossings.end(),
                                       [&](const Crossing& c) { return coincide(c.t, part.t1, c.cosine, Visibility::surface_offset); }),
                        crossings.end());
    PieceCutter cutter(part.t0, medium, pieces);
    for (std::size_t first = 0; first < crossings.size();) {
        const std::size_t end = group_end(crossings, first);
        for (std::size_t next = first; next < end; ++next) {
            const std::span<Crossing> group(crossings.data() + next, end - next), crossed(crossings.data() + first, next - first);
            bring_next_forward(group, crossed, cutter.medium());
            const bool again = group[0].from != cutter.medium() &&
                               std::any_of(crossed.begin(), crossed.end(), [&](const Crossing& done) { return same_side(done, group[0]); });
            if (!again) cutter.cross(group[0]);
        }
        first = end;
    }
    cutter.finish_piece(part.t1);
    return cutter.medium();
}

}  // namespace tyndall

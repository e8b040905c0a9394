#include "visibility/boundary_order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace tyndall;

namespace {

constexpr int A = 0, B = 1;

struct Cut {
    std::vector<int> media;
    std::vector<double> ends;
    int last;
};

Cut cut(std::initializer_list<Crossing> list, int start, const WalkedPart& part = {.t0 = 0, .t1 = 10, .at_surface = false})
{
    Crossings crossings(list);
    MediumPieces pieces;
    Cut result;
    result.last = cut_at_boundaries(crossings, part, start, pieces);
    double t = part.t0;
    for (const MediumPiece& piece : pieces) {
        EXPECT_EQ(piece.t0, t) << "pieces touch";
        t = piece.t1;
        result.media.push_back(piece.medium), result.ends.push_back(piece.t1);
    }
    return result;
}

Crossing at(double t, int shape, int from, int to, double cosine = 1)
{
    return {.t = t, .cosine = cosine, .shape = shape, .from = from, .to = to};
}

using testing::ElementsAre;

TEST(BoundaryOrder, CutsInOrderOfDistance)
{
    const Cut c = cut({at(7, 1, B, vacuum), at(2, 0, vacuum, A), at(5, 0, A, vacuum), at(6, 1, vacuum, B)}, vacuum);
    EXPECT_THAT(c.media, ElementsAre(vacuum, A, vacuum, B, vacuum));
    EXPECT_THAT(c.ends, ElementsAre(2, 5, 6, 7, 10));
}

TEST(BoundaryOrder, LeavesOneBoxBeforeEnteringTheNext)
{
    for (const double shift : {-1e-8, 0.0, 1e-8})  // within the rounding of the shared face
        EXPECT_EQ(cut({at(3 + shift, 1, vacuum, B), at(3, 0, A, vacuum)}, A).last, B) << shift;
    EXPECT_THAT(cut({at(3, 1, vacuum, B), at(3, 0, A, vacuum)}, A).media, ElementsAre(A, B));
}

TEST(BoundaryOrder, EntersTheOuterContainerBeforeTheInner)
{
    EXPECT_EQ(cut({at(3, 1, A, B), at(3 + 1e-9, 0, vacuum, A)}, vacuum).last, B);
    EXPECT_EQ(cut({at(3, 0, A, vacuum), at(3 + 1e-9, 1, B, A)}, B).last, vacuum);
}

TEST(BoundaryOrder, AnEdgeThatIsMetTwiceCountsOnce)
{
    const Cut c = cut({at(3, 0, A, vacuum), at(3, 0, A, vacuum), at(3, 1, vacuum, B)}, A);
    EXPECT_EQ(c.last, B);
    EXPECT_THAT(c.media, ElementsAre(A, B));
}

TEST(BoundaryOrder, GrazingASilhouetteEdgeChangesNothing)
{
    EXPECT_EQ(cut({at(3, 0, A, vacuum), at(3, 0, vacuum, A)}, vacuum).last, vacuum);
}

TEST(BoundaryOrder, ABoundaryOnTheSurfaceIsNotCrossed)
{
    EXPECT_EQ(cut({at(10 - 1e-9, 0, A, vacuum)}, A, {.t0 = 0, .t1 = 10, .at_surface = true}).last, A);
    EXPECT_EQ(cut({at(10 - 1e-3, 0, A, vacuum)}, A, {.t0 = 0, .t1 = 10, .at_surface = true}).last, vacuum);
    EXPECT_EQ(cut({at(10 - 1e-9, 0, A, vacuum)}, A).last, vacuum);
}

TEST(BoundaryOrder, AMediumThatDoesNotMatchFollowsTheNearestBoundary)
{
    EXPECT_THAT(cut({at(3, 0, A, vacuum)}, B).media, ElementsAre(B, vacuum));
}

}  // namespace

/// Walls that a packet of shadow segments need not ask: which ones are found, and that no answer changes.
#include "visibility/outer_walls.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "../transport/built_scene.hpp"
#include "transport/random_sequence.hpp"
#include "visibility/visibility.hpp"

using namespace tyndall;
using test::BuiltScene;

namespace {

std::vector<const Shape*> solids_of(const Scene& scene)
{
    std::vector<const Shape*> solids;
    for (const Shape& s : scene.shapes) solids.push_back(&s);
    return solids;
}

std::size_t kept(const BuiltScene& s)
{
    const OuterWalls walls(solids_of(s.scene));
    std::size_t triangles = 0;
    for (const Shape& shape : s.scene.shapes) triangles += walls.others(shape.mesh).size();
    return triangles;
}

/// A tilted room, so that its planes are not exact in float, with a ball and a block in it.
struct Room : BuiltScene {
    const Mat4 turn = glm::rotate(Mat4(1), .7, glm::normalize(Vec3(1, 2, .5)));
    const Vec3 half{.5, .4, .45};

    explicit Room(bool furnished = true)
    {
        mesh(cube_mesh(), turn * glm::scale(Mat4(1), half), diffuse(Rgb(.5)));
        if (!furnished) return;
        box({-.2, -.2, -.15}, {0, .1, .1}, 0);
        sphere({.2, .1, 0}, .12, 0);
    }
    /// Local coordinates from -1 to 1 are inside.
    Vec3 at(const Vec3& local) const { return Vec3(turn * glm::dvec4(local * half, 1)); }
};

ShadowPacket packet_between(const Vec3 (&from)[16], const Vec3 (&to)[16])
{
    ShadowPacket p{};
    for (int i = 0; i < 16; ++i) {
        const glm::vec3 o(from[i]), d = glm::vec3(to[i]) - o;
        p.origin_x[i] = o.x, p.origin_y[i] = o.y, p.origin_z[i] = o.z, p.direction_x[i] = d.x, p.direction_y[i] = d.y, p.direction_z[i] = d.z;
        const float margin = static_cast<float>(Visibility::endpoint_rounding) / glm::length(d);
        p.tnear[i] = margin, p.tfar[i] = 1 - margin, p.mask[i] = ~0u;
    }
    return p;
}

/// Coordinates as far out as `most`, some of them hardly inside of a wall or beyond it: of 16 segments all ends are inside half of the time.
Vec3 place(RandomSequence& random, double most)
{
    Vec3 local;
    for (int k = 0; k < 3; ++k) {
        local[k] = most * (2 * random.next() - 1);
        if (random.next() < .05) local[k] = (local[k] < 0 ? -1 : 1) * (1 - (random.next() - .1) * 4e-6);
    }
    return local;
}

Vec3 inner(RandomSequence& random) { return .999 * (2. * Vec3(random.next(), random.next(), random.next()) - 1.); }

bool blocked(const ShadowPacket& p, int i) { return p.tfar[i] == -std::numeric_limits<float>::infinity(); }

TEST(OuterWalls, AreTheSidesOfARoomAndNothingInIt)
{
    EXPECT_EQ(kept(Room()), 12u) << "the block";
    EXPECT_EQ(kept(Room(false)), 0u);
    EXPECT_EQ(OuterWalls(solids_of(Room().scene)).half_spaces().size(), 6u);
}

TEST(OuterWalls, AreNotKeptWhereTheySaveNothing)
{
    BuiltScene s;
    s.box({-.2, -.2, -.15}, {.4, .1, .1}, s.diffuse(Rgb(.5)));
    s.sphere({.2, .1, 0}, .3, 0);  // sticks out of every side but the left
    EXPECT_TRUE(OuterWalls(solids_of(s.scene)).empty());
}

TEST(OuterWalls, AWallThatSomethingStandsBehindIsNone)
{
    Room s(false);
    s.sphere(s.at({0, 0, 1.5}), .05, 0);
    EXPECT_EQ(kept(s), 2u) << "the side towards the ball";
}

// A wall through which a segment runs must never be left out, wherever the ends are. A packet with one lane that leaves the room is asked of the whole scene.
TEST(OuterWalls, LeaveEveryAnswerAsItIs)
{
    const Room room;
    const Visibility visibility(room.scene, 1);
    RandomSequence random(13, 0, RandomStream::pilot, 5);
    int differ = 0, stopped = 0, passed = 0;
    for (int n = 0; n < 10000; ++n) {
        Vec3 from[16], to[16];
        for (int i = 0; i < 16; ++i) from[i] = room.at(place(random, 1)), to[i] = room.at(place(random, n % 5 || i ? 1 : 1.3));
        std::vector<ShadowPacket> inside{packet_between(from, to)};
        from[15] = room.at({2, 0, 0});
        std::vector<ShadowPacket> leaving{packet_between(from, to)};
        visibility.occluded(inside), visibility.occluded(leaving);
        for (int i = 0; i < 15; ++i) (blocked(leaving[0], i) ? stopped : passed)++, differ += blocked(inside[0], i) != blocked(leaving[0], i);
    }
    EXPECT_GT(stopped, 10000);
    EXPECT_GT(passed, 10000);
    EXPECT_EQ(differ, 0) << "of " << stopped + passed;
}

TEST(OuterWalls, NothingGetsOutOfARoomThatIsFullOfWalls)
{
    const Room room;
    const Visibility visibility(room.scene, 1);
    RandomSequence random(13, 0, RandomStream::pilot, 6);
    for (int n = 0; n < 1000; ++n) {
        Vec3 from[16], to[16];
        for (int i = 0; i < 16; ++i) {
            from[i] = room.at(inner(random)), to[i] = room.at(inner(random));
            to[i] = i == n % 16 ? room.at({1 + 1e-5 + random.next(), .3, .2}) : to[i];  // one lane of sixteen leaves
        }
        std::vector<ShadowPacket> packets{packet_between(from, to)};
        visibility.occluded(packets);
        ASSERT_TRUE(blocked(packets[0], n % 16)) << n;
    }
}

TEST(OuterWalls, HoldNothingThatIsNotFinite)
{
    const OuterWalls walls(solids_of(Room().scene));
    const Vec3 middle[16]{};
    Vec3 to[16];
    for (Vec3& p : to) p = Vec3(.1);
    int valid[16];
    std::fill(valid, valid + 16, -1);
    ShadowPacket p = packet_between(middle, to);
    EXPECT_TRUE(walls.hold(p, valid));
    p.direction_y[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(walls.hold(p, valid));
    valid[3] = 0;
    EXPECT_TRUE(walls.hold(p, valid)) << "nobody asks";
}

}  // namespace

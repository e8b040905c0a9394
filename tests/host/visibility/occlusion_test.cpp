#include <gtest/gtest.h>
#include <immintrin.h>

#include <limits>
#include <vector>

#include "../transport/built_scene.hpp"
#include "transport/random_sequence.hpp"
#include "visibility/visibility.hpp"

using namespace tyndall;
using test::BuiltScene;

namespace {

RandomSequence numbers(std::uint64_t which) { return {13, 0, RandomStream::pilot, which}; }
Vec3 between(RandomSequence& random, const Vec3& low, const Vec3& high)
{
    return low + Vec3(random.next(), random.next(), random.next()) * (high - low);
}

BuiltScene closed_room()
{
    BuiltScene s;
    s.box({-.6, -.5, -.4}, {.6, .5, .4}, s.diffuse(Rgb(.5)));
    return s;
}

/// A point on a wall of the room, as tracing finds it: hit, then moved off the wall to the inside.
Vec3 on_a_wall(const Visibility& visibility, RandomSequence& random)
{
    const Vec3 from = between(random, {-.5, -.4, -.3}, {.5, .4, .3}), to = between(random, Vec3(-1), Vec3(1));
    Hit hit;
    const Vec3 d = glm::normalize(to - from);
    EXPECT_TRUE(visibility.intersect({.origin = from, .direction = d}, hit));
    return visibility.leave(hit, -d);
}

// Hard case 33: no light is lost inside a closed box, none gets out.
TEST(Occlusion, InAClosedRoomEveryPointSeesEveryOther)
{
    const BuiltScene s = closed_room();
    const Visibility visibility(s.scene, 1);
    RandomSequence random = numbers(1);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 a = i % 2 ? on_a_wall(visibility, random) : between(random, {-.6, -.5, -.4}, {.6, .5, .4});
        const Vec3 b = i % 4 < 2 ? on_a_wall(visibility, random) : between(random, {-.6, -.5, -.4}, {.6, .5, .4});
        ASSERT_FALSE(visibility.occluded(a, b)) << i;
        ASSERT_EQ(visibility.transmittance(a, vacuum, b), Rgb(1)) << i;
    }
}

TEST(Occlusion, NothingGetsOutOfAClosedRoomNotEvenFromPointsAtItsWalls)
{
    const BuiltScene s = closed_room();
    const Visibility visibility(s.scene, 1);
    RandomSequence random = numbers(2);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 outside = Vec3(2, .3, -.2) + between(random, Vec3(-.5), Vec3(.5));
        ASSERT_TRUE(visibility.occluded(between(random, {-.59, -.49, -.39}, {.59, .49, .39}), outside)) << i;
        // medium points a hair inside: float rounds them onto the wall or beyond it
        const Vec3 at_wall(.6 - std::pow(10, -4 - 12 * random.next()), random.next() - .5, .8 * random.next() - .4);
        const RayWalk walk = visibility.walk({.origin = at_wall, .direction = glm::normalize(outside - at_wall)}, vacuum);
        ASSERT_TRUE(walk.found) << i;
    }
}

TEST(Occlusion, NullSurfacesBlockNothing)
{
    BuiltScene s;
    s.box(Vec3(-.5), Vec3(.5), s.null());
    s.sphere(Vec3(0), .3, s.null());
    const Visibility visibility(s.scene, 1);
    EXPECT_FALSE(visibility.occluded({-1, 0, 0}, {1, 0, 0}));
    Hit hit;
    ASSERT_TRUE(visibility.intersect({.origin = {-1, 0, 0}, .direction = {1, 0, 0}}, hit));
    EXPECT_DOUBLE_EQ(hit.t, .5);
    EXPECT_FALSE(visibility.walk({.origin = {-1, 0, 0}, .direction = {1, 0, 0}}, vacuum).found);
}

TEST(Occlusion, BlockedSegmentsHaveInfiniteDepthAndNoTransmittance)
{
    BuiltScene s;
    s.sphere(Vec3(0), .3, s.diffuse(Rgb(.5)));
    const Visibility visibility(s.scene, 1);
    EXPECT_EQ(visibility.optical_depth({-1, 0, 0}, vacuum, {1, 0, 0}), Rgb(std::numeric_limits<double>::infinity()));
    EXPECT_EQ(visibility.transmittance({-1, 0, 0}, vacuum, {1, 0, 0}), Rgb(0));
    EXPECT_EQ(visibility.transmittance({-1, 0, 0}, vacuum, {-1, 0, 0}), Rgb(1));
}

// ---- sixteen at a time ----

struct Occluders : BuiltScene {
    Occluders()
    {
        sphere({.3, .1, 0}, .25, diffuse(Rgb(.5)));
        box({-.6, -.4, -.3}, {-.2, .2, .3}, 0);
        shape({.name = "cylinder",
               .type = Shape::Type::cylinder,
               .to_world = glm::translate(Mat4(1), Vec3(.2, -.6, 0)) * glm::scale(Mat4(1), Vec3(.2, .2, .4)),
               .bsdf = 0});
        container(Vec3(-.9), Vec3(.9), {});
    }
};

ShadowPacket idle_packet()
{
    ShadowPacket p{};
    for (int i = 0; i < SHADOW_PACKET_SIZE; ++i) p.direction_z[i] = 1, p.tfar[i] = -1, p.mask[i] = ~0u;
    return p;
}

void set_lane(ShadowPacket& p, int i, const Vec3& from, const Vec3& to)
{
    p.origin_x[i] = float(from.x), p.origin_y[i] = float(from.y), p.origin_z[i] = float(from.z);
    p.direction_x[i] = float(to.x - from.x), p.direction_y[i] = float(to.y - from.y), p.direction_z[i] = float(to.z - from.z);
    p.tnear[i] = 1e-6f, p.tfar[i] = 1 - 1e-6f, p.mask[i] = ~0u;
}

struct Segments {
    std::vector<ShadowPacket> packets;
    std::vector<std::pair<Vec3, Vec3>> ends;
};

Segments random_segments(int packets)
{
    Segments s;
    RandomSequence random = numbers(3);
    for (int p = 0; p < packets; ++p) {
        s.packets.push_back(idle_packet());
        for (int i = 0; i < SHADOW_PACKET_SIZE; ++i) {
            s.ends.emplace_back(between(random, Vec3(-.85), Vec3(.85)), between(random, Vec3(-.85), Vec3(.85)));
            if (i % 5) set_lane(s.packets.back(), i, s.ends.back().first, s.ends.back().second);
        }
    }
    return s;
}

TEST(ShadowPackets, AgreeWithSingleSegmentsAtAnyAlignmentAndThreadCount)
{
    const Occluders scene;
    for (const int threads : {1, 2}) {
        const Visibility visibility(scene.scene, threads);
        for (const std::size_t offset : {0, 4, 60}) {
            Segments s = random_segments(300);
            std::vector<std::byte> memory(s.packets.size() * sizeof(ShadowPacket) + 128);
            void* aligned = memory.data();
            std::size_t space = memory.size();
            ASSERT_TRUE(std::align(64, s.packets.size() * sizeof(ShadowPacket) + 64, aligned, space));
            auto* packets = reinterpret_cast<ShadowPacket*>(static_cast<std::byte*>(aligned) + offset);
            std::copy(s.packets.begin(), s.packets.end(), packets);
            visibility.occluded(std::span(packets, s.packets.size()));
            int blocked = 0, differ = 0;
            for (std::size_t k = 0; k < s.ends.size(); ++k) {
                const float tfar = packets[k / 16].tfar[k % 16];
                if (k % 16 % 5 == 0) {
                    ASSERT_EQ(tfar, -1) << "an idle lane was touched";
                    continue;
                }
                const bool packet_blocked = tfar == -std::numeric_limits<float>::infinity();
                ASSERT_TRUE(packet_blocked || tfar == 1 - 1e-6f);
                blocked += packet_blocked;
                differ += packet_blocked != visibility.occluded(s.ends[k].first, s.ends[k].second);
            }
            EXPECT_GT(blocked, 500);
            // only rays that pass an edge within float rounding (about 1e-7 of the size) may differ: expected .001 of 3900
            EXPECT_LE(differ, 1);
        }
    }
}

TEST(ShadowPackets, LanesThatAreNotFiniteAreBlockedCountedAndHarmNobody)
{
    const Occluders scene;
    const Visibility visibility(scene.scene, 1);
    std::vector<ShadowPacket> packets{idle_packet()};
    for (int i = 0; i < 5; ++i) set_lane(packets[0], i, {0, .8, 0}, {.1, .8, .1});
    packets[0].origin_x[1] = NAN, packets[0].direction_y[2] = INFINITY, packets[0].tnear[3] = -1,
    packets[0].origin_y[7] = NAN;  // lane 7 is idle
    visibility.occluded(packets);
    EXPECT_EQ(packets[0].tfar[0], 1 - 1e-6f);
    for (const int i : {1, 2, 3}) EXPECT_EQ(packets[0].tfar[i], -std::numeric_limits<float>::infinity());
    EXPECT_EQ(packets[0].tfar[4], 1 - 1e-6f);
    EXPECT_EQ(packets[0].tfar[7], -1);
    EXPECT_EQ(visibility.invalid_rays(), 3u);
}

TEST(ShadowPackets, ModeOfDenormalsIsRestored)
{
    const Occluders scene;
    const Visibility visibility(scene.scene, 1);
    Segments s = random_segments(2);
    const unsigned before = _mm_getcsr();
    visibility.occluded(s.packets);
    EXPECT_EQ(_mm_getcsr() & 0x8040, before & 0x8040);
}

TEST(ShadowPackets, ASceneWithoutSurfacesBlocksNothing)
{
    BuiltScene s;
    const Visibility visibility(s.scene, 1);
    Segments segments = random_segments(3);
    visibility.occluded(segments.packets);
    for (const ShadowPacket& p : segments.packets)
        for (const float tfar : p.tfar) EXPECT_NE(tfar, -std::numeric_limits<float>::infinity());
}

}  // namespace

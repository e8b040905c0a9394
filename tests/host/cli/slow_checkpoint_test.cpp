#include "resuming_fixture.hpp"

namespace tyndall::test {
namespace {

TEST_F(Resuming, KilledAtTwentyRandomMomentsGoesOnToTheSameBytes) { expect_killed_renders_go_on_to_the_same_bytes(20); }

}  // namespace
}  // namespace tyndall::test

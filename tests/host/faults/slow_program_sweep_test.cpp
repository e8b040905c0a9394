#include "program_sweep.hpp"

namespace tyndall::test {
TEST_F(ProgramSweep, EveryCallMayFail) { sweep(0, 1); }
}  // namespace tyndall::test

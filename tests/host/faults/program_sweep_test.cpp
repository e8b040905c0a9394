#include "program_sweep.hpp"

namespace tyndall::test {
TEST_F(ProgramSweep, SomeCallsMayFail) { sweep(1, 12); }
}  // namespace tyndall::test

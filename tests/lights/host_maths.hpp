#pragma once
/// The kernel mathematics on the host, with the sampler as a variable. For one source file per program; a light joins both precisions after it.
#include <gtest/gtest.h>

#include <string>

#include "glm/glm.hpp"

namespace tyndall {
static int tested_sampler = 0;  // the device's build option as a variable: every test can ask for its own
}
#define SAMPLER tested_sampler
#include "kernels/shared/records.hpp"
#include "tests/lights/lobes.hpp"
#include "tests/lights/plain_transport.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

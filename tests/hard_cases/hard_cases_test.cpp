// Every row against its oracle, on the host, in float and in double.
#include <gtest/gtest.h>

#include "tests/hard_cases/check_row.hpp"

namespace tyndall::test {

template <class Real>
class HardCases : public testing::Test {};
using Precisions = testing::Types<float, double>;
struct PrecisionNames {
    template <class Real>
    static std::string GetName(int) { return sizeof(Real) == 4 ? "float" : "double"; }
};
TYPED_TEST_SUITE(HardCases, Precisions, PrecisionNames);

#define HARD_CASE(name, row) \
    TYPED_TEST(HardCases, name) { check_row<TypeParam>(row<TypeParam>(), evaluate_each_on_host<TypeParam>); }
#include "selftest/rows.inc"

}  // namespace tyndall::test

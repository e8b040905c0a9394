/// The bias of every biased technique falls with its radius at the rate that kernels/README.md predicts, measured on whole images against the unbiased technique.
#include <gtest/gtest.h>

#include "bench/bias_slopes.hpp"

namespace tyndall::bias {
namespace {

class BiasSlope : public testing::TestWithParam<Study> {};

TEST_P(BiasSlope, IsThePredictedOne)
{
    const Study& study = GetParam();
    Biases biases = measure(study, usual_replicas);
    const Slope slope = slope_of(study, biases, usual_t);
    for (std::size_t k = 0; k < study.radii.size(); ++k) std::printf("radius %g: bias %.3g +- %.2g\n", study.radii[k], mean(biases.bias[k]), standard_error(biases.bias[k]));
    std::printf("slope %.3g +- %.2g, predicted %g\n", slope.value, slope.half_width, study.predicted);
    EXPECT_TRUE(slope.holds(study.predicted));
    EXPECT_LT(slope.half_width, .5) << "the measurement is too weak";
    // A kernel whose integral is wrong by 3 %, to the side of the bias: it does not go away with the radius.
    for (auto& replicas : biases.bias)
        for (const double wrong = std::copysign(.03, mean(replicas)); double& bias : replicas) bias += wrong;
    const Slope planted = slope_of(study, biases, usual_t);
    EXPECT_FALSE(planted.holds(study.predicted)) << "a kernel that is wrong by 3 % gives " << planted.value << " +- " << planted.half_width << ": the comparison is blind";
}

INSTANTIATE_TEST_SUITE_P(Biased, BiasSlope, testing::ValuesIn(studies()), [](const auto& info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

}  // namespace
}  // namespace tyndall::bias

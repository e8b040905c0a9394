/// What bench/bias_slopes.hpp measures, as JSON on standard output, for bench/bias_slopes.py. [STUDY] alone if it is named.
#include <cstdio>
#include <string_view>

#include "bench/bias_slopes.hpp"

int main(int count, char** words)
{
    using namespace tyndall::bias;
    bool first = true;
    std::printf("{");
    for (const Study& study : studies()) {
        if (count > 1 && study.name != std::string_view(words[1])) continue;
        const Biases biases = measure(study, usual_replicas);
        const Slope slope = slope_of(study, biases, usual_t);
        std::printf("%s\n\"%s\": {\"layer\": \"%s\", \"predicted\": %g, \"slope\": %.4g, \"half_width\": %.3g, \"unbiased\": %.6g, \"unbiased_error\": %.2g, \"bias\": [", first ? "" : ",", study.name.c_str(),
                    std::string(name(study.layer)).c_str(), study.predicted, slope.value, slope.half_width, biases.unbiased, biases.error);
        for (std::size_t k = 0; k < study.radii.size(); ++k)
            std::printf("%s[%g, %.5g, %.2g]", k ? ", " : "", study.radii[k], mean(biases.bias[k]), standard_error(biases.bias[k]));
        std::printf("]}"), first = false;
        std::fflush(stdout);
    }
    std::printf("\n}\n");
}

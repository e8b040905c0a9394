// The golden tables with the first potential of row 7 twice what it is. Linked before the program's own.
#define golden_floats right_golden_floats
#include "host/selftest/golden.cpp"
#undef golden_floats

namespace tyndall {

GoldenTable<float> golden_floats();

GoldenTable<float> golden_floats()
{
    static const std::vector<GoldenSet<float>> sets = [] {
        const auto right = right_golden_floats().sets;
        std::vector<GoldenSet<float>> wrong(right.begin(), right.end());
        for (GoldenSet<float>& set : wrong) {
            if (set.row != row07) continue;
            GoldenOutput<float>& potential = set.out[0];
            potential.value *= 2, potential.low *= 2, potential.high *= 2;
            break;
        }
        return wrong;
    }();
    return {sets, right_golden_floats().means};
}

}  // namespace tyndall

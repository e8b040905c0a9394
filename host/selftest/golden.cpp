#include "selftest/golden.hpp"

namespace tyndall {
namespace {

/// HARD_CASE(name, table) of rows.inc as an index.
enum Row : int {
#define HARD_CASE(name, row) row,
#include "selftest/rows.inc"
};

constexpr std::string_view names[] = {
#define HARD_CASE(name, row) #name,
#include "selftest/rows.inc"
};

/// Words of the tables: an infinite input, an output that must be finite, one in an interval without a single right value, one with it.
template <class Real>
struct Words {
    static constexpr Real INFINITE = std::numeric_limits<Real>::infinity();
    static constexpr GoldenOutput<Real> FINITE{};
    static constexpr GoldenOutput<Real> BETWEEN(Real low, Real high) { return {FINITE.value, low, high}; }
    static constexpr GoldenOutput<Real> NEAR(Real value, Real low, Real high) { return {value, low, high}; }
};

struct Floats : Words<float> {
    static constexpr GoldenSet<float> sets[] = {
#define GOLDEN_SETS
#include "selftest/golden_float.inc"
#undef GOLDEN_SETS
    };
    static constexpr GoldenMean<float> means[] = {
#define GOLDEN_MEANS
#include "selftest/golden_float.inc"
#undef GOLDEN_MEANS
    };
};

struct Doubles : Words<double> {
    static constexpr GoldenSet<double> sets[] = {
#define GOLDEN_SETS
#include "selftest/golden_double.inc"
#undef GOLDEN_SETS
    };
    static constexpr GoldenMean<double> means[] = {
#define GOLDEN_MEANS
#include "selftest/golden_double.inc"
#undef GOLDEN_MEANS
    };
};

}  // namespace

GoldenTable<float> golden_floats() { return {Floats::sets, Floats::means}; }
GoldenTable<double> golden_doubles() { return {Doubles::sets, Doubles::means}; }
std::span<const std::string_view> golden_rows() { return names; }

}  // namespace tyndall

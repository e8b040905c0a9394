#pragma once
/// Renders of the reference scenes and their z-test against the reference images (README.md).
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "support/image_comparison.hpp"
#include "tyndall/settings.hpp"

namespace tyndall::test {

/// A quantity of a scene and how it is rendered: the sum of `layers` of `scene`, to be compared with references/`reference`.mean.exr.
struct ReferenceCase {
    std::string name;           ///< of the test
    std::string scene;          ///< scenes/`scene`.xml
    std::string reference;      ///< "<scene>.<tag>"
    std::vector<Layer> layers;  ///< empty: all
    RenderSettings settings;    ///< seed and layers are filled in
};
void PrintTo(const ReferenceCase& test_case, std::ostream* out);

/// The median relative standard error of an 8x8 block of the mean of the eight renders must be at most this: only then has the comparison's
/// limit on chi^2 a false-alarm rate under 1 %, in spite of the noise that pixels share.
inline constexpr double largest_block_error = .006;

/// One render each with the seeds 1 to 8, which nobody may change.
std::vector<ImageRgb> eight_renders(const ReferenceCase& test_case);

ImageComparison compare_with_reference(const std::vector<ImageRgb>& renders, const std::string& reference);

/// Renders and expects that the comparison passes and that the block error is small enough for it to mean something.
void expect_agreement(const ReferenceCase& test_case);

/// The quantities of one scene, each named "<letter>_<quantity>". Settings hold method, passes and lights.
ReferenceCase whole_image(const std::string& scene, const RenderSettings& settings);
ReferenceCase at_most_one_scattering(const std::string& scene, const RenderSettings& settings);  ///< emitted + single, black surfaces
ReferenceCase all_media_to_media(const std::string& scene, const RenderSettings& settings);      ///< black surfaces
ReferenceCase double_scattering(const std::string& scene, RenderSettings settings);              ///< black surfaces

inline constexpr const char *fog_room = "a_cornell_iso", *juice = "b_juice_spot", *fog_cube = "i_bounded_fog", *plume = "d_plume_iso";

}  // namespace tyndall::test

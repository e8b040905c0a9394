#pragma once
/// `tyndall compare`: two images, or the methods and settings for a scene at equal time.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tyndall {

struct CompareCommand {
    std::vector<std::filesystem::path> inputs;  ///< image.exr reference.exr
    std::vector<std::string> layers;            ///< of the EXRs; empty: the image
    std::optional<double> tolerance;            ///< on the error, the root of relMSE; none: any error is fine
    bool json = false;
};

/// Two images: prints how far the first is from the second. Returns ExitCode::outside_tolerance beyond the tolerance. Throws UsageError, SceneError, IoError.
int run_compare(const CompareCommand& command);

}  // namespace tyndall

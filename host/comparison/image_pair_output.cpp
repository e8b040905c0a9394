#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/image_pair.hpp"
#include "report/readable.hpp"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

std::string line(const char* what, const std::string& value) { return fmt::format("  {:<34}{}\n", what, value); }

std::string signed_percent(double share) { return fmt::format("{:+.3f} %", 100 * share); }

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string noise_of_bias(const ImagePair& pair)
{
    if (!pair.noise_relative_mse) return "";
    return fmt::format("   (standard error {:.3f} % if pixels err alone, {:.3f} % if all err together)", 100 * pair.bias_error_low, 100 * pair.bias_error_high);
}

}  // namespace

std::string to_table(const ImagePair& pair, const ImageFile& image, const ImageFile& reference)
{
    const ImageError& e = pair.error;
    std::string text = fmt::format("{} against {}: {} x {} pixels\n", terminal_safe(image.file.string()), terminal_safe(reference.file.string()), image.width, image.height);
    text += line("error (root of relMSE)", readable_percent(std::sqrt(e.relative_mse)));
    text += line("relMSE", fmt::format("{:.4g}", e.relative_mse));
    text += line("relMSE, largest .1 % left out", fmt::format("{:.4g}", e.trimmed_relative_mse));
    text += line("relMSE that noise explains", pair.noise_relative_mse ? fmt::format("{:.4g}", *pair.noise_relative_mse) : "unknown: variances are not in both files");
    if (std::isfinite(pair.blocks_relative_mse)) text += line("relMSE of means over 8 x 8", fmt::format("{:.4g}", pair.blocks_relative_mse));
    text += line("RMSE", fmt::format("{:.4g}", e.rmse));
    text += line("mean", fmt::format("{:.6g}, of the reference {:.6g}", e.mean, e.reference_mean));
    text += line("bias of the mean", signed_percent(pair.bias) + noise_of_bias(pair));
    text += line("block of 8 x 8 that differs most", fmt::format("{} at ({}, {})", signed_percent(pair.block.relative), pair.block.x, pair.block.y));
    text += line("pixel that differs most", fmt::format("{:+.4g} at ({}, {})", e.worst_difference, pair.worst_x, pair.worst_y));
    return text + line("share of the largest .1 %", readable_percent(e.share_of_largest));
}

std::string to_json(const ImagePair& pair, const ImageFile& image, const ImageFile& reference)
{
    const ImageError& e = pair.error;
    const Json noise = pair.noise_relative_mse ? number(*pair.noise_relative_mse) : Json(nullptr);
    const Json json{{"schema", "tyndall-image-comparison/1"},
                    {"image", image.file.string()},
                    {"reference", reference.file.string()},
                    {"width", image.width},
                    {"height", image.height},
                    {"error", number(std::sqrt(e.relative_mse))},
                    {"relative_mse", number(e.relative_mse)},
                    {"trimmed_relative_mse", number(e.trimmed_relative_mse)},
                    {"blocks_relative_mse", number(pair.blocks_relative_mse)},
                    {"noise_relative_mse", noise},
                    {"rmse", number(e.rmse)},
                    {"mean", number(e.mean)},
                    {"reference_mean", number(e.reference_mean)},
                    {"bias", number(pair.bias)},
                    {"bias_error", noise.is_null() ? Json(nullptr) : Json{number(pair.bias_error_low), number(pair.bias_error_high)}},
                    {"worst_block", {{"x", pair.block.x}, {"y", pair.block.y}, {"relative", number(pair.block.relative)}}},
                    {"worst_pixel", {{"x", pair.worst_x}, {"y", pair.worst_y}, {"difference", number(e.worst_difference)}}},
                    {"share_of_largest", number(e.share_of_largest)},
                    {"warnings", pair.warnings}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tyndall

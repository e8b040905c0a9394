/// api::Image and api::Preview.
#include <fmt/format.h>

#include <algorithm>

#include "cli/outputs.hpp"
#include "library/api_state.hpp"

namespace tyndall::api {

Image::Image(std::unique_ptr<State> state) : state_(std::move(state)) {}
Image::~Image() = default;
Image::Image(Image&&) noexcept = default;
Image& Image::operator=(Image&&) noexcept = default;

int Image::width() const { return state_->render.films[0].width(); }
int Image::height() const { return state_->render.films[0].height(); }
int Image::passes() const { return state_->render.films[0].passes(); }
std::span<const float> Image::beauty() const { return state_->beauty; }
std::span<const float> Image::layer(Layer layer) const { return state_->layers.at(static_cast<std::size_t>(layer)); }
std::span<const float> Image::variance() const { return state_->variance; }
double Image::error() const { return state_->error; }
const std::string& Image::stopped_by() const { return state_->render.report.stopped_by; }
const std::string& Image::report() const { return state_->report; }

void Image::write(const std::filesystem::path& exr) const
{
    Report report = state_->render.report;
    write_outputs(plan_outputs(report.scene.empty() ? "scene" : report.scene, exr, {}), state_->render.films[0], state_->render.window, {}, state_->render.asked, report);
}

void Preview::beauty(std::span<float> rgb) const
{
    const std::size_t pixels = state_.film.pixels();
    if (rgb.size() != 3 * pixels) throw UsageError(fmt::format("a span of {} floats for {} pixels; give three each", rgb.size(), pixels));
    for (std::size_t i = 0; i < pixels; ++i) {
        const Rgb c = state_.film.beauty(i);
        for (int k = 0; k < 3; ++k) rgb[3 * i + static_cast<std::size_t>(k)] = static_cast<float>(c[k]);
    }
}

}  // namespace tyndall::api

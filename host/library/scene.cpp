/// api::Scene.
#include <fmt/format.h>

#include "library/api_state.hpp"
#include "library/scene_from_description.hpp"
#include "scene/load_scene.hpp"

namespace tyndall::api {
namespace {

std::shared_ptr<const Scene::State> shared(tyndall::Scene&& scene) { return std::make_shared<const Scene::State>(Scene::State{std::move(scene)}); }

tyndall::LoadOptions options_of(const LoadOptions& options) { return {.definitions = options.definitions, .allow_outside = options.allow_outside}; }

}  // namespace

Scene Scene::load(const std::filesystem::path& file, const LoadOptions& options) { return Scene(shared(load_scene(file, options_of(options)))); }

Scene Scene::parse(const std::string& xml, const std::filesystem::path& folder, const std::string& name, const LoadOptions& options)
{
    return Scene(shared(parse_scene(xml, folder, name, options_of(options))));
}

Scene::Scene(const SceneDescription& description) : state_(shared(scene_from(description))) {}

Scene Scene::with_film(int width, int height) const
{
    if (width < 1 || height < 1 || width > 65536 || height > 65536) throw UsageError(fmt::format("a film of {} x {} pixels; each side has 1 to 65536", width, height));
    tyndall::Scene scene = state_->scene;
    tyndall::Camera& camera = scene.camera;
    camera.width = camera.crop_width = width, camera.height = camera.crop_height = height, camera.crop_x = camera.crop_y = 0;
    return Scene(shared(std::move(scene)));
}

int Scene::width() const { return state_->scene.camera.crop_width; }
int Scene::height() const { return state_->scene.camera.crop_height; }
const std::vector<std::string>& Scene::warnings() const { return state_->scene.warnings; }

}  // namespace tyndall::api

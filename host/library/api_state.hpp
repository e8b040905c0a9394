#pragma once
/// What stands behind the handles of the public API.
#include <optional>

#include "film/film.hpp"
#include "pipeline/render_state.hpp"
#include "report/report.hpp"
#include "scene/scene.hpp"
#include "tyndall/tyndall.hpp"

namespace tyndall::api {

struct Scene::State {
    tyndall::Scene scene;
};

struct Image::State {
    RenderState render;  ///< with one film
    std::vector<float> beauty, variance;
    std::array<std::vector<float>, layer_count> layers;
    double error = -1;
    std::string report;
};

struct Preview::State {
    const Film& film;
};

}  // namespace tyndall::api

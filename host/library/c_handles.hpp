#pragma once
/// What stands behind the handles of the C interface.
#include "tyndall/backend.hpp"
#include "tyndall/tyndall.h"
#include "tyndall/tyndall.hpp"

struct tyndall_description {
    tyndall::api::SceneDescription data;
    std::vector<tyndall::api::Container> containers;  ///< for backends
};
struct tyndall_scene {
    tyndall::api::Scene scene;
};
struct tyndall_stop {
    tyndall::StopFlag flag;
};
struct tyndall_settings {
    tyndall::RenderSettings settings;
    std::uint64_t max_bytes = 0;
    tyndall_progress_callback progress = nullptr;
    tyndall_log_callback log = nullptr;
    void* user = nullptr;
};
struct tyndall_image {
    tyndall::api::Image image;
};

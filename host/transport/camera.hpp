#pragma once
/// Camera rays. Every technique of one pass asks here with the same numbers, so that all layers of a pass see the same camera sample.
#include <cstdint>

#include "scene/scene.hpp"
#include "transport/random_sequence.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

struct CameraSample {
    Ray ray;      ///< starts on the near plane, ends on the far plane
    int medium;   ///< at its start
    Vec2 film;    ///< position on the uncropped film in pixels, y down
    double near;  ///< distance along the ray from the camera's position to the ray's origin
};

/// The ray through a point of the uncropped film, in pixels, y down.
CameraSample camera_ray(const Camera& camera, const Vec2& film);

/// One sample of pixel (x, y) of the crop window, distributed as the camera's reconstruction filter around the pixel's centre: its weight
/// is 1.
CameraSample sample_camera(const Camera& camera, int x, int y, RandomSequence& random);

/// The camera sample of a pass: numbers from RandomStream::camera.
CameraSample sample_camera(const Camera& camera, int x, int y, std::uint64_t seed, std::uint64_t pass);

}  // namespace tyndall

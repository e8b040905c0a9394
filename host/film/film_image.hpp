#pragma once
/// A film as the channels of an OpenEXR image.
#include "film/exr.hpp"
#include "film/film.hpp"

namespace tyndall {

/// Where the film lies in the whole picture, pixels.
struct FilmWindow {
    int x = 0, y = 0, full_width = 0, full_height = 0;
};

struct FilmImageOptions {
    bool half = false;  ///< radiance, albedo and N in 16 bits; variance, samples and Z never are
    LayerSet layers;    ///< main layers to write even if the film lacks them: black, because the scene holds none of their light
};

/// Beauty `R G B`; a layer `name.R name.G name.B` for each main layer of the film or the options and for each `.specular` one that a pass
/// brought; `variance.R/G/B`, the variance of the mean of the beauty (0 for a single pass, where it is unknown); `samples`, the number of
/// passes; `albedo.R/G/B`, `N.X/Y/Z` and `Z` if the passes brought features.
ExrImage to_exr_image(const Film& film, const FilmWindow& window, const FilmImageOptions& options = {});

}  // namespace tyndall

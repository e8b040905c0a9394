#pragma once
/// A scene as plain data, for callers that have no file. Lengths are in any unit; extinction is per that unit. Colours are linear red, green, blue. The camera and
/// what is written about each element are those of scene files (host/docs/scenes.md). Nothing is kept: api::Scene copies all of it.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tyndall::api {

using Triple = std::array<double, 3>;

inline constexpr int vacuum = -1;  ///< the index of no medium

/// How a medium scatters, by mu, the cosine between the directions of travel before and after.
struct Phase {
    enum class Type { isotropic, henyey_greenstein, rayleigh, table };
    Type type = Type::isotropic;
    double g = 0;                ///< Henyey and Greenstein's mean cosine, in (-1, 1)
    std::vector<double> values{};  ///< table: two or more, >= 0 and not all 0, at equally spaced mu from -1 to 1; scaled to integrate to 1
};

/// Voxels of density in an upright box, outside of which there is nothing. Values are those at the centres of voxels, trilinear between them.
struct Grid {
    std::array<int, 3> size{};  ///< voxels along x, y, z
    std::vector<float> values{};  ///< [z][y][x], finite and >= 0; size x * y * z of them
    Triple low{0, 0, 0}, high{1, 1, 1};  ///< corners of the box
};

struct Medium {
    std::string name = "medium";  ///< for messages
    Triple sigma_t{1, 1, 1};      ///< extinction, >= 0; with a density: where the density is 1
    Triple albedo{.75, .75, .75}; ///< share of it that scatters, in [0, 1]
    Phase phase{};
    std::optional<Grid> density{};  ///< none: homogeneous
};

/// Colours over texture coordinates (u, v).
struct Texture {
    enum class Type { picture, checkerboard };
    enum class Filter { bilinear, nearest };
    enum class Wrap { repeat, mirror, clamp };  ///< what continues a picture beyond [0, 1]^2
    std::string name = "texture";
    Type type = Type::picture;
    int width = 0, height = 0;         ///< picture: pixels
    int channels = 3;                  ///< picture: 1 (grey) or 3
    std::vector<float> texels{};         ///< picture: [y][x][channel], linear, in [0, 1]; row 0 is at v = 0, the centre of pixel (x, y) at ((x + 1/2) / width, (y + 1/2) / height)
    Filter filter = Filter::bilinear;
    Wrap wrap = Wrap::repeat;
    Triple even{.4, .4, .4}, odd{.2, .2, .2};  ///< checkerboard: squares of half a unit, `even` at the origin; in [0, 1]
    std::array<double, 6> to_uv{1, 0, 0, 0, 1, 0};  ///< two rows of three numbers: what (u, v, 1) becomes before it is looked up
};

/// What a surface does with light.
struct Bsdf {
    enum class Type { null, diffuse, dielectric, conductor, thin_dielectric, rough_dielectric, rough_conductor, plastic, rough_plastic };
    std::string name = "bsdf";
    Type type = Type::diffuse;
    Triple reflectance{.5, .5, .5};    ///< in [0, 1]; diffuse, and what mirrors, glass and the boundary of plastics reflect (give 1 there)
    Triple transmittance{1, 1, 1};     ///< in [0, 1]; what glass lets through
    double eta = 1.5046;               ///< glass and plastics: index of refraction inside over outside, in (.01, 100)
    Triple conductor_eta{0, 0, 0}, conductor_k{1, 1, 1};  ///< metals; the default is a perfect mirror
    double alpha = .1;                 ///< rough ones: root mean square slope times sqrt(2), in [1e-4, 10]
    bool ggx = false;                  ///< rough ones: GGX in place of Beckmann
    bool two_sided = false;            ///< diffuse, metals and plastics: the back behaves as the front
    std::optional<int> reflectance_texture{}, transmittance_texture{};  ///< in place of those colours, by index into SceneDescription::textures
    Triple below{.5, .5, .5};          ///< plastics: what lies below the boundary reflects, in [0, 1]
    std::optional<int> below_texture{};
    bool nonlinear = false;            ///< plastics: light that the boundary throws back inside takes on the colour of `below` again
};

/// Triangles, counter-clockwise seen from outside.
struct Mesh {
    std::string name = "mesh";
    std::vector<Triple> vertices{};
    std::vector<Triple> normals{};       ///< of vertices, unit, or none: flat
    std::vector<std::array<std::uint32_t, 3>> triangles{};
    int bsdf = 0;                      ///< index into SceneDescription::bsdfs
    std::optional<int> interior{}, exterior{};  ///< media inside and outside, by index, or vacuum; neither: the mesh bounds no medium
    std::optional<Triple> radiance{};    ///< it glows outwards, W/m2/sr
    std::vector<std::array<double, 2>> uvs{};  ///< texture coordinates of vertices, or none
};

/// Radiance from far away, by direction: the first row of the picture is straight up, the last straight down, columns turn around.
struct EnvironmentMap {
    std::string name = "environment map";
    int width = 0, height = 0;         ///< pixels, at least 2 each, at most 2^25 altogether
    std::vector<float> texels{};         ///< [y][x][r, g, b], linear, finite and >= 0, W/m2/sr
};

struct Emitter {
    enum class Type { point, spot, directional, constant, environment };
    std::string name = "emitter";
    Type type = Type::point;
    Triple value{1, 1, 1};             ///< intensity (point, spot; W/sr), irradiance (directional; W/m2), radiance (constant; W/m2/sr), factor of the map (environment)
    Triple position{0, 0, 0};          ///< point, spot
    Triple direction{0, 0, 1};         ///< spot, directional: of travel, of any length but 0
    double cutoff_degrees = 20, beam_degrees = 15;  ///< spot: half angles where it is dark, and up to which it is full
    int medium = vacuum;               ///< that it stands in
    int map = 0;                       ///< environment: index into SceneDescription::environment_maps
    Triple up{0, 1, 0}, middle{0, 0, 1};  ///< environment: where the first row, and the middle of the picture, lie; of any length but 0, not parallel; `middle` is made orthogonal to `up`
};

/// A pinhole camera and its film.
struct Camera {
    Triple origin{0, 0, -4}, target{0, 0, 0}, up{0, 1, 0};
    double fov_degrees = 40;           ///< full horizontal angle, in (0, 180)
    double near_clip = .01, far_clip = 1e4;  ///< along the viewing axis
    int width = 640, height = 480;     ///< pixels
    bool box_filter = false;           ///< false: gaussian of .5 pixels
    int medium = vacuum;               ///< that it stands in
};

struct SceneDescription {
    std::string name = "scene built in memory";  ///< for messages and the report
    std::vector<Medium> media{};
    std::vector<Bsdf> bsdfs{};           ///< at least one if there is a mesh
    std::vector<Mesh> meshes{};
    std::vector<Emitter> emitters{};
    Camera camera{};
    int max_depth = -1;                ///< paths have at most max_depth - 1 scattering vertices; -1: no limit
    std::vector<Texture> textures{};
    std::vector<EnvironmentMap> environment_maps{};
};

}  // namespace tyndall::api

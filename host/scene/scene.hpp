#pragma once
/// A validated scene: plain data. What the loader returns and everything else reads. Nothing here knows XML, Embree or OpenCL.
///
/// Render space: `load_scene` translates the scene so that the centre of its bounding box is the origin and scales it by a power of two so that
/// the box's half diagonal lies in (1/2, 1]; extinctions, point and spot intensities follow (`scene/render_space.hpp`). All lengths below are in render
/// space; `Scene::unit` gives the scene file's units back. Hence every epsilon of the tracing code is relative to 1.
#include <cstdint>
#include <string>
#include <vector>

#include "scene/vector.hpp"

namespace tyndall {

/// Where in a scene file something was said; line and column count from 1, line 0 means "nowhere in a file" (built in memory or a default).
struct SourceLocation {
    std::string file;
    int line = 0, column = 0;
};

/// "file:line:column" (or "scene built in memory").
std::string to_string(const SourceLocation& where);

/// A distribution over mu, the cosine between the directions of travel before and after: 1 is straight on. What is not isotropic or Henyey and
/// Greenstein's is made by scene/phases.hpp.
struct PhaseFunction {
    enum class Type { isotropic, henyey_greenstein, rayleigh, table, blend };
    Type type = Type::isotropic;
    double g = 0;                          ///< mean of mu, in (-1, 1); in [-1, 1] for a table
    std::vector<double> values{};          ///< table: per steradian, at two or more equally spaced mu from -1 to 1, linear between; integrates to 1
    std::vector<double> cumulative{};      ///< table: probability of a mu below that of every value; 0 ... 1
    std::vector<PhaseFunction> parts{};    ///< blend: two or more, none of them a blend
    double weight = 1;                     ///< of a part of a blend, in (0, 1]; those of all parts sum to 1
};

/// A box of voxels. Values are given at the centres of the voxels, trilinear between them, those of the outermost centres up to the faces of the box, and 0
/// outside of it. (An albedo has no outside: the loader lets its grid reach over the whole box of the medium's density.)
struct Volume {
    std::string name;           ///< of its file
    int size_x = 1, size_y = 1, size_z = 1;
    int channels = 1;           ///< 1 or 3 (r, g, b)
    std::vector<float> values;  ///< [channel][z][y][x]; finite, >= 0
    Mat4 to_world{1};           ///< of the unit cube [0, 1]^3, to render space; affine
    SourceLocation where;
};

inline constexpr int none = -1;    ///< "no such thing" for every index but a medium's

/// A participating medium; coefficients per unit of render-space length, scale already applied. It is homogeneous unless it has a volume.
struct Medium {
    std::string name;
    Rgb sigma_t{0};            ///< extinction, >= 0; with a density: extinction where the density is 1
    Rgb albedo{0};             ///< in [0, 1]; with an albedo volume: that volume's largest value per channel
    PhaseFunction phase;
    SourceLocation where;
    int density = none;        ///< index into Scene::volumes: extinction is sigma_t x its value (per channel), 0 outside of its box
    int albedo_volume = none;  ///< index into Scene::volumes: albedo is its value, in [0, 1]
    bool homogeneous() const { return density == none && albedo_volume == none; }
    /// Scattering, where the density is 1 and the albedo is largest.
    Rgb sigma_s() const { return albedo * sigma_t; }
};

inline constexpr int vacuum = -1;  ///< medium index of empty space

/// Colours over texture coordinates; scene/texture_lookup.hpp says which colour is where.
struct Texture {
    enum class Type { bitmap, checkerboard };
    enum class Filter { bilinear, nearest };
    enum class Wrap { repeat, mirror, clamp };  ///< what continues a bitmap beyond [0, 1]^2
    std::string name;            ///< of a bitmap's file, or the element's id or type
    Type type = Type::bitmap;
    int width = 1, height = 1;   ///< bitmap
    int channels = 1;            ///< bitmap: 1 (grey) or 3 (r, g, b)
    std::vector<float> texels{}; ///< bitmap: [y][x][channel], linear, finite, >= 0; row 0 is at v = 0, the top of the picture
    Filter filter = Filter::bilinear;
    Wrap wrap = Wrap::repeat;
    Rgb even{.4}, odd{.2};       ///< checkerboard: squares of half a unit; `even` at the origin
    Mat4 to_uv{1};               ///< what texture coordinates (u, v, 0, 1) become before they are looked up
    Rgb largest{1};              ///< per channel
    SourceLocation where;
};

/// Facets of a rough surface (scene/microfacet.hpp): Gaussian slopes (Beckmann) or GGX's longer tail.
struct Roughness {
    enum class Type { beckmann, ggx };
    Type type = Type::beckmann;
    double alpha_u = .1, alpha_v = .1;  ///< root mean square slope times sqrt(2) along and across dp/du; >= 1e-4
};

struct Bsdf {
    enum class Type { null, diffuse, dielectric, conductor, thin_dielectric, rough_dielectric, rough_conductor, plastic, rough_plastic };
    std::string name;
    Type type = Type::diffuse;
    Rgb reflectance{.5};             ///< diffuse; specular_reflectance of all others
    Rgb specular_transmittance{1};   ///< dielectrics, thin and rough ones too
    double eta = 1.5046;             ///< dielectrics and plastics: interior over exterior index of refraction
    Rgb conductor_eta{0}, conductor_k{1};
    bool two_sided = false;          ///< the front's behaviour on the back too, or `back`
    int back = none;                 ///< index of another Bsdf for the back of a `twosided` with two children
    SourceLocation where;
    Roughness roughness{};           ///< rough ones
    Rgb diffuse{.5};                 ///< plastics: reflectance of what lies below the boundary
    bool nonlinear = false;          ///< plastics: light that the boundary throws back inside takes on the colour of `diffuse` again
    double internal_reflectance = 0;             ///< plastics (scene/plastic.hpp): of diffuse light, by the boundary, from inside
    std::vector<double> boundary_transmittance;  ///< rough_plastic: at equally spaced cosines from 0 to 1
    /// Indices into Scene::textures that take the place of reflectance, specular_transmittance and diffuse, which then hold the textures' largest values.
    int reflectance_texture = none, transmittance_texture = none, diffuse_texture = none;
};

/// Triangles in render space. Normals are shading normals per vertex, or empty.
struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<Vec3> normals;
    std::vector<Vec2> uvs;
    std::vector<glm::uvec3> triangles;
    bool closed = false;  ///< every edge is shared by exactly two triangles, oppositely directed
    bool convex = false;  ///< closed, and every vertex lies behind every triangle's plane
};

struct Shape {
    enum class Type { mesh, sphere, disk, cylinder };  ///< rectangle, cube, obj and ply become meshes
    std::string name;                 ///< id, or the element's type
    Type type = Type::mesh;
    Mesh mesh;                        ///< for Type::mesh
    Mat4 to_world{1};                 ///< sphere: unit sphere; disk: unit disk in xy facing +z; cylinder: radius 1 around z from 0 to 1. Already applied to meshes.
    bool flip_normals = false;
    int bsdf = 0;                     ///< index into Scene::bsdfs
    int emitter = none;               ///< index into Scene::emitters, of an area emitter
    bool medium_boundary = false;     ///< has an interior or exterior: crossing it sets the medium by the side of the outward normal
    int interior = vacuum, exterior = vacuum;
    SourceLocation where;
};

/// Radiance from far away, by direction; made by scene/environment_maps.hpp.
struct EnvironmentMap {
    std::string name;            ///< of its file
    int width = 2, height = 2;   ///< the first row is straight up (local +y), the last straight down, columns turn around; at least 2 each
    std::vector<float> texels{}; ///< [y][x][r, g, b], linear, finite, >= 0
    std::vector<double> rows{};    ///< cumulative probability of the cells between rows y and y + 1, by luminance x solid angle: height - 1 values that end at 1
    std::vector<double> columns{}; ///< [y][x] the same of the cells of a row, given the row; each row ends at 1
    Rgb mean{0};                 ///< over all directions
    SourceLocation where;
};

struct Emitter {
    enum class Type { point, spot, area, directional, constant, envmap };
    std::string name;
    Type type = Type::point;
    Rgb value{1};                     ///< intensity (point, spot; W/sr), radiance (area, constant; W/m2/sr), irradiance (directional; W/m2), factor of the map (envmap)
    Vec3 position{0};                 ///< point, spot
    Vec3 direction{0, 0, 1};          ///< spot: axis; directional: direction of travel; unit length
    double cutoff = .349, beam = .262;  ///< spot: half angles in radians; falloff linear in the angle between them
    int shape = none;                 ///< area: the shape that glows (on its normal's side)
    int map = none;                   ///< envmap: index into Scene::environment_maps
    Mat3 map_to_world{1};             ///< envmap: a rotation (or reflection)
    int medium = vacuum;              ///< the medium at the emitter's surface or position, from its ref
    SourceLocation where;
    /// Its light comes from beyond everything: it has directions, but no place.
    bool outside() const { return type == Type::directional || type == Type::constant || type == Type::envmap; }
};

struct Filter {
    enum class Type { box, gaussian };
    Type type = Type::gaussian;
    double stddev = .5;               ///< gaussian, in pixels; truncated at 4 stddev
};

struct Camera {
    Mat4 to_world{1};                 ///< camera looks along local +z, image x to the right is local -x, y up is local +y (Mitsuba); rigid in render space
    double fov_x = .9;                ///< full horizontal angle of the uncropped film, radians
    double near_clip = .01, far_clip = 1e4;  ///< render-space distances along the viewing axis
    double principal_x = 0, principal_y = 0; ///< principal_point_offset, in fractions of the film
    int width = 768, height = 576;    ///< uncropped film, pixels
    int crop_x = 0, crop_y = 0, crop_width = 768, crop_height = 576;
    Filter filter;
    int medium = vacuum;              ///< the medium that the camera is in, from its ref
    SourceLocation where;
};

struct Scene {
    std::string file;
    std::uint64_t hash = 0;           ///< of the scene file's bytes, of every file that it names, and of the -D definitions
    std::vector<Volume> volumes;      ///< that media refer to
    std::vector<Medium> media;
    std::vector<Bsdf> bsdfs;
    std::vector<Texture> textures;    ///< that surfaces refer to
    std::vector<EnvironmentMap> environment_maps;  ///< that emitters refer to
    std::vector<Shape> shapes;
    std::vector<Emitter> emitters;
    Camera camera;
    int max_depth = -1;               ///< of the scene's integrator: paths have at most max_depth - 1 scattering vertices, null crossings not counted; -1: no limit
    std::string integrator;           ///< type named by the scene ("" if none): reported, ours to choose
    Vec3 centre{0};                   ///< scene-file position of render space's origin
    double unit = 1;                  ///< scene-file length of one render-space unit (a power of two)
    std::vector<std::string> warnings;  ///< each with file:line:column and what to do
};

/// Axis-aligned bounds in render space; of a scene: of all shapes, camera, positional emitters, and grids whose medium no shape holds.
struct Bounds {
    Vec3 low{1e300}, high{-1e300};
    void grow(const Vec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
    bool empty() const { return low.x > high.x; }
    Vec3 centre() const { return .5 * (low + high); }
    double radius() const { return .5 * glm::length(high - low); }
};
Bounds bounds_of(const Scene& scene);
Bounds bounds_of(const Shape& shape);
Bounds bounds_of(const Volume& volume);

}  // namespace tyndall

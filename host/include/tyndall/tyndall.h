/// Tyndall for C, and for every language that can call C. What is promised of threads, ownership, units and memory stands in host/docs/library.md.
///
/// Handles are opaque; the caller destroys what it was given by a function called ..._create, ..._load, ..._parse or tyndall_render. Destroying NULL does nothing. Functions
/// that can fail return a status; then tyndall_last_error() of the same thread says why, and nothing was given out. No exception leaves a function, and none may enter
/// through a callback.
#ifndef TYNDALL_H
#define TYNDALL_H

#include <stddef.h>
#include <stdint.h>

#include "tyndall/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Grows when functions are added; what is there does not change. tyndall_abi_version() is that of the library that is loaded.
#define TYNDALL_ABI_VERSION 3
TYNDALL_API int tyndall_abi_version(void);
/// "0.1.0 (commit)".
TYNDALL_API const char* tyndall_version(void);

/// The exit codes of the program.
enum {
    TYNDALL_OK = 0,
    TYNDALL_INTERNAL_ERROR = 1,   ///< or out of memory
    TYNDALL_USAGE_ERROR = 2,      ///< an argument or a setting that makes no sense
    TYNDALL_SCENE_ERROR = 3,
    TYNDALL_NO_DEVICE = 4,
    TYNDALL_DEVICE_ERROR = 5,
    TYNDALL_IO_ERROR = 6,
    TYNDALL_TEMPORARY_ERROR = 75  ///< writing failed for a reason that may be gone at another try
};
typedef int tyndall_status;

/// The sentence of the last failure on this thread, "" if there was none; valid until the next failure on this thread.
TYNDALL_API const char* tyndall_last_error(void);

typedef struct tyndall_description tyndall_description;  ///< a scene that is being made
typedef struct tyndall_scene tyndall_scene;              ///< a scene that was found to be valid; it never changes
typedef struct tyndall_settings tyndall_settings;
typedef struct tyndall_stop tyndall_stop;
typedef struct tyndall_image tyndall_image;

/* Scenes from files. */

TYNDALL_API tyndall_status tyndall_scene_load(const char* file, tyndall_scene** scene);
/// The same with `count` values for the <default>s of the file, names[i] = values[i]; allow_outside: anything but 0 lets the scene name files outside of its own folder.
TYNDALL_API tyndall_status tyndall_scene_load_with(const char* file, const char* const* names, const char* const* values, size_t count, int allow_outside, tyndall_scene** scene);
/// `xml`: the text of such a file; `folder`: where the files that it names are looked for; `name`: for messages.
TYNDALL_API tyndall_status tyndall_scene_parse(const char* xml, const char* folder, const char* name, tyndall_scene** scene);
/// The same scene on another film, without a crop window, as a handle of its own; both sides from 1 to 65536.
TYNDALL_API tyndall_status tyndall_scene_with_film(const tyndall_scene* scene, int width, int height, tyndall_scene** other);
TYNDALL_API void tyndall_scene_destroy(tyndall_scene* scene);
TYNDALL_API int tyndall_scene_width(const tyndall_scene* scene);
TYNDALL_API int tyndall_scene_height(const tyndall_scene* scene);
/// Warning number `index` from 0, or NULL if there are no more; valid as long as the scene.
TYNDALL_API const char* tyndall_scene_warning(const tyndall_scene* scene, int index);

/* Scenes from memory: everything is copied. Elements are numbered from 0 in the order in which they are added, each kind by itself. `index` may be NULL. */

#define TYNDALL_VACUUM (-1)       ///< the number of no medium
#define TYNDALL_NO_BOUNDARY (-2)  ///< for both sides of a mesh: it bounds no medium

TYNDALL_API tyndall_status tyndall_description_create(tyndall_description** description);
TYNDALL_API void tyndall_description_destroy(tyndall_description* description);
/// Homogeneous; extinction per unit of length and albedo as r, g, b; g: Henyey and Greenstein's mean cosine, in (-1, 1), 0: isotropic.
TYNDALL_API tyndall_status tyndall_add_medium(tyndall_description* description, const double* sigma_t, const double* albedo, double g, int* index);
/// Rayleigh's phase function in place of the medium's.
TYNDALL_API tyndall_status tyndall_set_rayleigh(tyndall_description* description, int medium);
/// A table in its place: `count` values, two or more, >= 0, at equally spaced cosines between the directions of travel from -1 (straight back) to 1.
TYNDALL_API tyndall_status tyndall_set_phase_table(tyndall_description* description, int medium, const double* values, size_t count);
/// Voxels x * y * z of density ([z][y][x]) between two corners: the extinction of that medium is sigma_t times the density, and 0 outside.
TYNDALL_API tyndall_status tyndall_set_density(tyndall_description* description, int medium, int x, int y, int z, const float* values, const double* low, const double* high);
/// A boundary without a surface.
TYNDALL_API tyndall_status tyndall_add_null(tyndall_description* description, int* index);
TYNDALL_API tyndall_status tyndall_add_diffuse(tyndall_description* description, const double* reflectance, int two_sided, int* index);
/// Glass, eta: index of refraction inside over outside; alpha 0: smooth, else Beckmann's roughness.
TYNDALL_API tyndall_status tyndall_add_dielectric(tyndall_description* description, double eta, double alpha, int* index);
/// Metal; eta and k as r, g, b.
TYNDALL_API tyndall_status tyndall_add_conductor(tyndall_description* description, const double* eta, const double* k, double alpha, int* index);
/// Something diffuse (below: r, g, b) under a boundary of dielectric; alpha as for glass.
TYNDALL_API tyndall_status tyndall_add_plastic(tyndall_description* description, const double* below, double eta, double alpha, int two_sided, int* index);
/// Triangles, counter-clockwise seen from outside: 3 doubles per vertex, 3 numbers per triangle. interior, exterior: media; radiance: r, g, b, or NULL if it does not glow.
TYNDALL_API tyndall_status tyndall_add_mesh(tyndall_description* description, const double* vertices, size_t vertex_count, const uint32_t* triangles, size_t triangle_count, int bsdf,
                                            int interior, int exterior, const double* radiance, int* index);
/// Shading normals, 3 doubles for each vertex of a mesh.
TYNDALL_API tyndall_status tyndall_set_normals(tyndall_description* description, int mesh, const double* normals, size_t count);
/// `medium`: what the light stands in, or TYNDALL_VACUUM.
TYNDALL_API tyndall_status tyndall_add_point(tyndall_description* description, const double* intensity, const double* position, int medium);
TYNDALL_API tyndall_status tyndall_add_spot(tyndall_description* description, const double* intensity, const double* position, const double* direction, double cutoff_degrees,
                                            double beam_degrees, int medium);
TYNDALL_API tyndall_status tyndall_add_directional(tyndall_description* description, const double* irradiance, const double* direction);
TYNDALL_API tyndall_status tyndall_add_constant(tyndall_description* description, const double* radiance);
/// Light from far away, by direction: width * height * 3 floats >= 0, the first row straight up, columns turn around; `factor` as r, g, b. up, middle: where the first row and
/// the middle of the picture lie; NULL: (0, 1, 0), (0, 0, 1).
TYNDALL_API tyndall_status tyndall_add_environment(tyndall_description* description, int width, int height, const float* texels, const double* factor, const double* up,
                                                   const double* middle);
/// Paths have at most max_depth - 1 scattering vertices; -1, as without this: no limit.
TYNDALL_API tyndall_status tyndall_set_max_depth(tyndall_description* description, int max_depth);
/// Horizontal field of view.
TYNDALL_API tyndall_status tyndall_set_camera(tyndall_description* description, const double* origin, const double* target, const double* up, double fov_degrees, int width, int height,
                                              int medium);

/// A picture as texture: width * height * channels (1 or 3) floats in [0, 1], linear; row 0 is at v = 0. Bilinear between pixels and repeated unless tyndall_set_lookup says otherwise.
TYNDALL_API tyndall_status tyndall_add_picture(tyndall_description* description, int width, int height, int channels, const float* texels, int* index);
/// Squares of half a unit in two colours, `even` at the origin. Pictures and checkerboards are numbered together.
TYNDALL_API tyndall_status tyndall_add_checkerboard(tyndall_description* description, const double* even, const double* odd, int* index);
enum { TYNDALL_BILINEAR = 0, TYNDALL_NEAREST = 1 };
enum { TYNDALL_REPEAT = 0, TYNDALL_MIRROR = 1, TYNDALL_CLAMP = 2 };
/// `to_uv`: two rows of three numbers, what (u, v, 1) becomes before it is looked up; NULL: as it was.
TYNDALL_API tyndall_status tyndall_set_lookup(tyndall_description* description, int texture, int filter, int wrap, const double* to_uv);
#define TYNDALL_NO_TEXTURE (-1)
/// Textures in place of what a bsdf reflects (of plastics: of what lies below) and, of glass, lets through.
TYNDALL_API tyndall_status tyndall_set_textures(tyndall_description* description, int bsdf, int reflectance, int transmittance);
/// u, v for each vertex of a mesh.
TYNDALL_API tyndall_status tyndall_set_texture_coordinates(tyndall_description* description, int mesh, const double* uvs, size_t count);

/// The description may be destroyed, or go on to the next scene.
TYNDALL_API tyndall_status tyndall_scene_create(const tyndall_description* description, tyndall_scene** scene);

/* Settings. */

TYNDALL_API tyndall_status tyndall_settings_create(tyndall_settings** settings);
TYNDALL_API void tyndall_settings_destroy(tyndall_settings* settings);
/// What the option `--name` of `tyndall render` sets, from the same text: ("passes", "64"), ("layer", "single,media_to_media"), ("no-selftest", "true").
TYNDALL_API tyndall_status tyndall_settings_set(tyndall_settings* settings, const char* name, const char* value);
/// Refuse what is estimated to take more memory on host and device; 0: no bound.
TYNDALL_API void tyndall_settings_max_bytes(tyndall_settings* settings, uint64_t bytes);
/// The caller's cl_context and cl_device_id, and a cl_command_queue that is in order, or NULL. They are retained while a render runs.
TYNDALL_API void tyndall_settings_opencl(tyndall_settings* settings, void* context, void* device, void* queue);

typedef struct tyndall_progress {
    size_t size;                     ///< bytes of this struct, as the library knows it
    int passes_done, passes_wanted;  ///< wanted 0: until the time is up
    double seconds, seconds_left;
    double error;                    ///< estimated root of the relative mean square error; negative: unknown yet
    int width, height;
    const void* film;                ///< for tyndall_preview, during the callback
} tyndall_progress;

/// After every pass, on the thread that called tyndall_render; anything but 0 ends the render with the passes so far.
typedef int (*tyndall_progress_callback)(void* user, const tyndall_progress* progress);
/// level 0: information, 1: a warning, 2: an error, which is the call's status and tyndall_last_error() as well.
typedef void (*tyndall_log_callback)(void* user, int level, const char* text);
/// Either may be NULL.
TYNDALL_API void tyndall_settings_callbacks(tyndall_settings* settings, tyndall_progress_callback progress, tyndall_log_callback log, void* user);
/// The picture so far: width * height * 3 floats.
TYNDALL_API tyndall_status tyndall_preview(const tyndall_progress* progress, float* rgb, size_t floats);

/// A flag that ends renders from any thread or signal handler. It must outlive the renders that it was given to.
TYNDALL_API tyndall_status tyndall_stop_create(tyndall_stop** stop);
TYNDALL_API void tyndall_stop_raise(tyndall_stop* stop);
TYNDALL_API void tyndall_stop_destroy(tyndall_stop* stop);
TYNDALL_API void tyndall_settings_stop(tyndall_settings* settings, const tyndall_stop* stop);

/* Images. */

/// settings NULL: the program's.
TYNDALL_API tyndall_status tyndall_render(const tyndall_scene* scene, const tyndall_settings* settings, tyndall_image** image);
TYNDALL_API void tyndall_image_destroy(tyndall_image* image);
TYNDALL_API int tyndall_image_width(const tyndall_image* image);
TYNDALL_API int tyndall_image_height(const tyndall_image* image);
TYNDALL_API int tyndall_image_passes(const tyndall_image* image);
/// As in tyndall_progress.
TYNDALL_API double tyndall_image_error(const tyndall_image* image);
/// "passes", "time", "target error" or "interrupt".
TYNDALL_API const char* tyndall_image_stopped_by(const tyndall_image* image);
/// "beauty", "variance" (of the mean of the beauty) or the name of a layer: width * height * 3 floats, rows from the top, valid as long as the image; NULL if there is no such layer.
TYNDALL_API const float* tyndall_image_layer(const tyndall_image* image, const char* name);
/// JSON.
TYNDALL_API const char* tyndall_image_report(const tyndall_image* image);
/// Layered OpenEXR into a file *.exr, with .png and .json beside it.
TYNDALL_API tyndall_status tyndall_image_write(const tyndall_image* image, const char* exr);

/* The connections alone, for a renderer that traces by itself: tyndall/backend.hpp says what each record means. Layouts are the same. */

typedef struct tyndall_ray_light {
    float origin[3], length, direction[3];
    uint32_t medium;
    float flux[3];
    uint32_t padding;
} tyndall_ray_light;

typedef struct tyndall_point_light {
    float position[3];
    uint32_t medium;
    float direction[3];
    uint32_t padding_0;
    float power[3];
    uint32_t padding_1;
} tyndall_point_light;

typedef struct tyndall_eye_segment {
    float origin[3], length, direction[3];
    uint32_t medium;
    float throughput[3];
    uint32_t padding;
} tyndall_eye_segment;

#define TYNDALL_NO_MEDIUM 0xffffffffu  ///< of an eye point in vacuum

typedef struct tyndall_eye_point {
    float position[3];
    uint32_t medium;
    float normal[3];
    uint32_t padding_0;
    float facing[3];
    uint32_t padding_1;
    float throughput[3];
    uint32_t padding_2;
} tyndall_eye_point;

typedef struct tyndall_shadow_segment {
    double from[3], to[3];
    uint32_t medium, padding;
} tyndall_shadow_segment;

/// Writes 1 for every segment that something stands across, else 0. Anything but 0 as its result ends the call that asked, with TYNDALL_USAGE_ERROR.
typedef int (*tyndall_occluded)(void* user, const tyndall_shadow_segment* segments, size_t count, uint8_t* blocked);

/// Writes what passes along every segment, r, g, b each; 0 where something stands across. Its result is as that of tyndall_occluded.
typedef int (*tyndall_transmittance)(void* user, const tyndall_shadow_segment* segments, size_t count, float* passed);

typedef struct tyndall_backend tyndall_backend;

/// For backends, where scenes have meshes: a convex polyhedron that a medium fills, in vacuum, as 4 to 64 half-spaces of 4 doubles each, x n[0] + y n[1] + z n[2] <= n[3]. Containers are
/// disjoint. None: between an eye and a light is the light's medium and nothing else.
TYNDALL_API tyndall_status tyndall_add_container(tyndall_description* description, int medium, const double* planes, size_t plane_count);

/// Takes the media and containers of a description (nothing else of it is looked at), and of the settings the device or the caller's OpenCL objects, lanes, no-selftest, max_bytes,
/// the stop flag and the log callback, which hears warnings and errors of calls with the backend; NULL: none. low, high: a box that holds every light and eye. occluded NULL: nothing stands between.
TYNDALL_API tyndall_status tyndall_backend_create(const tyndall_description* media, const tyndall_settings* settings, const double* low, const double* high, tyndall_occluded occluded,
                                                  void* user, tyndall_backend** backend);
/// The same for media of any shape: `passed` says what both `occluded` and containers would, and a description with containers is refused.
TYNDALL_API tyndall_status tyndall_backend_create_passing(const tyndall_description* media, const tyndall_settings* settings, const double* low, const double* high,
                                                          tyndall_transmittance passed, void* user, tyndall_backend** backend);
TYNDALL_API void tyndall_backend_destroy(tyndall_backend* backend);

/// How to estimate: a seed, independent rounds (variances take two), and lights per eye, 0: all.
typedef struct tyndall_connect {
    uint64_t seed;
    int32_t rounds;
    uint32_t lights_per_eye;
} tyndall_connect;

/// r, g, b per eye into radiance and, unless it is NULL, variance.
TYNDALL_API tyndall_status tyndall_rays_to_segments(tyndall_backend* backend, const tyndall_ray_light* lights, size_t light_count, const tyndall_eye_segment* eyes, size_t eye_count,
                                                    const tyndall_connect* how, float* radiance, float* variance);
TYNDALL_API tyndall_status tyndall_rays_to_points(tyndall_backend* backend, const tyndall_ray_light* lights, size_t light_count, const tyndall_eye_point* eyes, size_t eye_count,
                                                  const tyndall_connect* how, float* radiance, float* variance);
TYNDALL_API tyndall_status tyndall_points_to_segments(tyndall_backend* backend, const tyndall_point_light* lights, size_t light_count, const tyndall_eye_segment* eyes, size_t eye_count,
                                                      const tyndall_connect* how, float* radiance, float* variance);
TYNDALL_API tyndall_status tyndall_points_to_points(tyndall_backend* backend, const tyndall_point_light* lights, size_t light_count, const tyndall_eye_point* eyes, size_t eye_count,
                                                    const tyndall_connect* how, float* radiance, float* variance);

/* Devices. */

/// How many OpenCL devices there are.
TYNDALL_API int tyndall_device_count(void);
/// "platform: name", by index; with what it lacks in parentheses if it cannot be used. Valid until the next call on this thread; NULL beyond the last.
TYNDALL_API const char* tyndall_device_name(int index);

#ifdef __cplusplus
}
#endif

#endif

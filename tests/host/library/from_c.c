/* The C interface as a C compiler sees it: a scene from memory, a render with callbacks, layers, refusals. Exit code 0 if all is as it should be. */
#include "tyndall/tyndall.h"

#include <stdio.h>
#include <string.h>

static int failures = 0;

#define EXPECT(condition)                                                                                           \
    do {                                                                                                            \
        if (!(condition)) fprintf(stderr, "line %d: not so: %s (%s)\n", __LINE__, #condition, tyndall_last_error()), ++failures; \
    } while (0)

struct heard {
    int passes, sentences;
    float preview[3 * 16 * 12];
};

static int after_pass(void* user, const tyndall_progress* progress)
{
    struct heard* heard = user;
    EXPECT(progress->size == sizeof *progress);
    EXPECT(progress->width == 16 && progress->height == 12);
    EXPECT(tyndall_preview(progress, heard->preview, 3 * 16 * 12) == TYNDALL_OK);
    EXPECT(tyndall_preview(progress, heard->preview, 5) == TYNDALL_USAGE_ERROR);
    return ++heard->passes == 2;
}

static void log_sentence(void* user, int level, const char* text)
{
    struct heard* heard = user;
    EXPECT(level >= 0 && level <= 2);
    EXPECT(strlen(text) > 0);
    ++heard->sentences;
}

static tyndall_scene* fog(void)
{
    const double sigma_t[3] = {.5, 1, 2}, albedo[3] = {.9, .7, .5}, white[3] = {3, 3, 3}, grey[3] = {.5, .5, .5}, place[3] = {0, .5, 0};
    const double origin[3] = {0, 0, 5}, target[3] = {0, 0, 0}, up[3] = {0, 1, 0};
    const double corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}};
    const uint32_t sides[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    tyndall_description* description = NULL;
    tyndall_scene* scene = NULL;
    int medium = -7, boundary = -7, surface = -7, mesh = -7;
    EXPECT(tyndall_description_create(&description) == TYNDALL_OK);
    EXPECT(tyndall_add_medium(description, sigma_t, albedo, .5, &medium) == TYNDALL_OK && medium == 0);
    EXPECT(tyndall_add_null(description, &boundary) == TYNDALL_OK && boundary == 0);
    EXPECT(tyndall_add_diffuse(description, grey, 1, &surface) == TYNDALL_OK && surface == 1);
    EXPECT(tyndall_add_mesh(description, corners[0], 8, sides[0], 12, boundary, medium, TYNDALL_VACUUM, NULL, &mesh) == TYNDALL_OK && mesh == 0);
    EXPECT(tyndall_add_point(description, white, place, medium) == TYNDALL_OK);
    EXPECT(tyndall_add_mesh(description, NULL, 8, sides[0], 12, 0, 0, 0, NULL, NULL) == TYNDALL_USAGE_ERROR);
    EXPECT(strstr(tyndall_last_error(), "vertices is NULL") != NULL);
    EXPECT(tyndall_set_camera(description, origin, target, up, 30, 16, 12, TYNDALL_VACUUM) == TYNDALL_OK);
    EXPECT(tyndall_scene_create(description, &scene) == TYNDALL_OK);
    tyndall_description_destroy(description);
    return scene;
}

static void render(const tyndall_scene* scene, tyndall_settings* settings)
{
    static struct heard heard;
    tyndall_image* image = NULL;
    const float* beauty;
    EXPECT(tyndall_settings_set(settings, "passes", "5") == TYNDALL_OK);
    EXPECT(tyndall_settings_set(settings, "lights", "64") == TYNDALL_OK);
    EXPECT(tyndall_settings_set(settings, "no-selftest", "true") == TYNDALL_OK);
    tyndall_settings_callbacks(settings, after_pass, log_sentence, &heard);
    EXPECT(tyndall_render(scene, settings, &image) == TYNDALL_OK);
    EXPECT(heard.passes == 2 && heard.sentences >= 1);
    EXPECT(tyndall_image_passes(image) == 2 && strcmp(tyndall_image_stopped_by(image), "interrupt") == 0);
    EXPECT(tyndall_image_width(image) == 16 && tyndall_image_height(image) == 12);
    beauty = tyndall_image_layer(image, "beauty");
    EXPECT(beauty != NULL && memcmp(beauty, heard.preview, sizeof heard.preview) == 0);
    EXPECT(tyndall_image_layer(image, "media_to_media") != NULL && tyndall_image_layer(image, "variance") != NULL);
    EXPECT(tyndall_image_layer(image, "no such layer") == NULL);
    EXPECT(strstr(tyndall_image_report(image), "\"passes\": 2") != NULL);
    EXPECT(tyndall_image_write(image, "/nowhere/at/all.exr") == TYNDALL_IO_ERROR);
    tyndall_image_destroy(image);
}

int main(void)
{
    tyndall_scene* scene = fog();
    tyndall_settings* settings = NULL;
    tyndall_image* image = (tyndall_image*)&failures;
    EXPECT(tyndall_abi_version() == TYNDALL_ABI_VERSION && strlen(tyndall_version()) > 0);
    EXPECT(tyndall_settings_create(&settings) == TYNDALL_OK);
    EXPECT(tyndall_settings_set(settings, "pases", "5") == TYNDALL_USAGE_ERROR && strstr(tyndall_last_error(), "passes") != NULL);
    render(scene, settings);
    EXPECT(tyndall_settings_set(settings, "device", "no such device") == TYNDALL_OK);
    EXPECT(tyndall_render(scene, settings, &image) == TYNDALL_NO_DEVICE && image == NULL);
    EXPECT(tyndall_device_count() > 0 && tyndall_device_name(0) != NULL && tyndall_device_name(-1) == NULL);
    tyndall_settings_destroy(settings);
    tyndall_scene_destroy(scene);
    tyndall_scene_destroy(NULL);
    return failures != 0;
}

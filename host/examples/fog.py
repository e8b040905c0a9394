#!/usr/bin/env python3
"""Renders a box of fog from Python, by ctypes and NumPy alone, writes fog.exr, fog.png and fog.json, and shows the image: in a window where Matplotlib is installed, otherwise in the terminal.

    python3 fog.py [fog.exr] [--no-show]     libtyndall.so is looked for where the dynamic linker looks; TYNDALL_LIBRARY names it otherwise
"""
import ctypes
import os
import sys

import numpy as np

tyndall = ctypes.CDLL(os.environ.get("TYNDALL_LIBRARY", "libtyndall.so.0"))
tyndall.tyndall_last_error.restype = ctypes.c_char_p
tyndall.tyndall_image_layer.restype = ctypes.POINTER(ctypes.c_float)
tyndall.tyndall_image_error.restype = ctypes.c_double
VACUUM, NO_BOUNDARY = -1, -2


def check(status):
    if status:
        raise RuntimeError(tyndall.tyndall_last_error().decode())


def numbers(*values):
    return (ctypes.c_double * len(values))(*values)


def number(value):
    return ctypes.c_double(value)


def make(function, *arguments):
    """Calls a function whose last argument is the place for a handle."""
    handle = ctypes.c_void_p()
    check(function(*arguments, ctypes.byref(handle)))
    return handle


def add_mesh(scene, vertices, triangles, bsdf, interior=NO_BOUNDARY, exterior=NO_BOUNDARY):
    vertices, triangles = np.ascontiguousarray(vertices, np.float64), np.ascontiguousarray(triangles, np.uint32)
    check(tyndall.tyndall_add_mesh(scene, vertices.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(len(vertices)), triangles.ctypes.data_as(ctypes.c_void_p),
                                   ctypes.c_size_t(len(triangles)), bsdf, interior, exterior, None, None))


def box_of_fog():
    scene = make(tyndall.tyndall_description_create)
    check(tyndall.tyndall_add_medium(scene, numbers(.8, .9, 1), numbers(.9, .9, .9), number(.5), None))  # medium 0
    check(tyndall.tyndall_add_null(scene, None))  # bsdf 0
    check(tyndall.tyndall_add_diffuse(scene, numbers(.6, .5, .4), 1, None))  # bsdf 1
    corners = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    sides = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    add_mesh(scene, corners, sides, 0, interior=0, exterior=VACUUM)
    add_mesh(scene, [(-4, -1.1, -4), (4, -1.1, -4), (4, -1.1, 4), (-4, -1.1, 4)], [(0, 2, 1), (0, 3, 2)], 1)
    check(tyndall.tyndall_add_spot(scene, numbers(60, 60, 50), numbers(2, 3, 1), numbers(-2, -3, -1), number(20), number(15), VACUUM))
    check(tyndall.tyndall_set_camera(scene, numbers(0, .5, 6), numbers(0, -.2, 0), numbers(0, 1, 0), number(35), 64, 48, VACUUM))
    made = make(tyndall.tyndall_scene_create, scene)
    tyndall.tyndall_description_destroy(scene)
    return made


def layer(image, name):
    shape = (tyndall.tyndall_image_height(image), tyndall.tyndall_image_width(image), 3)
    pixels = tyndall.tyndall_image_layer(image, name.encode())
    return np.ctypeslib.as_array(pixels, shape).copy() if pixels else np.zeros(shape, np.float32)


def show(beauty):
    """A window, or characters of 24-bit colour in the terminal, each of which is two pixels: its upper half and what is below."""
    picture = np.uint8(255 * np.clip(beauty / np.percentile(beauty, 99), 0, 1) ** (1 / 2.2))
    try:
        import matplotlib.pyplot as plot
    except ImportError:
        for upper, lower in zip(picture[::2], picture[1::2]):
            print("".join("\x1b[38;2;{};{};{};48;2;{};{};{}m\u2580".format(*a, *b) for a, b in zip(upper, lower)) + "\x1b[0m")
    else:
        plot.imshow(picture)
        plot.show()


def main():
    names = [argument for argument in sys.argv[1:] if argument != "--no-show"]
    scene, settings = box_of_fog(), make(tyndall.tyndall_settings_create)
    check(tyndall.tyndall_settings_set(settings, b"passes", b"8"))
    image = make(tyndall.tyndall_render, scene, settings)
    beauty, fog = layer(image, "beauty"), layer(image, "media_to_media") + layer(image, "single")
    print(f"{beauty.shape[1]} x {beauty.shape[0]} pixels, mean {beauty.mean():.4f}, of it scattered by the fog {fog.mean():.4f}, error {tyndall.tyndall_image_error(image):.1%}")
    check(tyndall.tyndall_image_write(image, (names[0] if names else "fog.exr").encode()))
    if "--no-show" not in sys.argv:
        show(beauty)
    for destroy, handle in ((tyndall.tyndall_image_destroy, image), (tyndall.tyndall_settings_destroy, settings), (tyndall.tyndall_scene_destroy, scene)):
        destroy(handle)


main()

"""One scene, and for each effect the same scene with that effect alone.

The base is a cube of grey, isotropic, homogeneous fog with a lamp beside it and nothing else: media_to_media needs no kernel feature there. All lengths are of the
same size in every variant, so that what differs is the effect.
"""
import os
import struct

SENSOR = """<sensor type="perspective"><float name="fov" value="45"/><float name="near_clip" value=".001"/><float name="far_clip" value="100"/>
  <transform name="to_world"><lookat origin="0, .3, 4" target="0, 0, 0" up="0, 1, 0"/></transform>
  <film type="hdrfilm"><integer name="width" value="128"/><integer name="height" value="128"/><string name="component_format" value="float32"/><rfilter type="box"/></film></sensor>"""
LAMP = """<emitter type="point"><point name="position" value="1.4, 1.8, 1.1"/><rgb name="intensity" value="5, 5, 5"/></emitter>"""
GREY, COLOURED = "1, 1, 1", ".4, 1, 1.6"
ISOTROPIC = '<phase type="isotropic"/>'
HENYEY_GREENSTEIN = '<phase type="hg"><float name="g" value=".6"/></phase>'
RAYLEIGH = '<phase type="rayleigh"/>'


def medium(name="fog", sigma_t=GREY, phase=ISOTROPIC):
    return f'<medium type="homogeneous" id="{name}"><rgb name="sigma_t" value="{sigma_t}"/><float name="albedo" value=".9"/>{phase}</medium>'


def grid_medium(channels):
    """A ball of smoke that fades outwards, of about the same mean extinction as the fog."""
    return f"""<medium type="heterogeneous" id="fog"><volume name="sigma_t" type="gridvolume"><string name="filename" value="smoke{channels}.vol"/>
  <transform name="to_world"><scale x="2" y="2" z="2"/><translate x="-1" y="-1" z="-1"/></transform></volume>
  <float name="scale" value="1"/><float name="albedo" value=".9"/>{ISOTROPIC}</medium>"""


def write_grid(folder, channels, size=32):
    values = []
    for z in range(size):
        for y in range(size):
            for x in range(size):
                r2 = sum((2 * (i + .5) / size - 1) ** 2 for i in (x, y, z))
                values += [max(0, 2.6 * (1 - r2)) * tint for tint in ((1,) if channels == 1 else (.4, 1, 1.6))]
    with open(os.path.join(folder, f"smoke{channels}.vol"), "wb") as file:
        file.write(b"VOL\x03" + struct.pack("<5i6f", 1, size, size, size, channels, 0, 0, 0, 1, 1, 1) + struct.pack(f"<{len(values)}f", *values))


def container(shape="cube", where="", inside="fog"):
    return f'<shape type="{shape}"><transform name="to_world">{where}<scale x="1" y="1" z="1"/></transform><bsdf type="null"/><ref name="interior" id="{inside}"/></shape>'


BALL = """<shape type="sphere"><transform name="to_world"><scale x=".25" y=".25" z=".25"/><translate x=".4" y="-.3" z=".2"/></transform>
  <bsdf type="diffuse"><rgb name="reflectance" value="0"/></bsdf></shape>"""
LEFT, RIGHT = '<scale x=".48" y="1" z="1"/><translate x="-.5"/>', '<scale x=".48" y="1" z="1"/><translate x=".5"/>'

# effect: (elements of the scene, options of the program, files to write)
VARIANTS = {
    "none": ([medium(), container()], [], None),
    "ANISOTROPIC": ([medium(phase=HENYEY_GREENSTEIN), container()], [], None),
    "PHASE_LOBES": ([medium(phase=RAYLEIGH), container()], [], None),
    "COLOURED": ([medium(sigma_t=COLOURED), container()], [], None),
    "OCCLUDERS": ([medium(), container(), BALL], [], None),
    "BOUNDARIES": ([medium(), container(where=LEFT), container(where=RIGHT)], [], None),
    "MANY_MEDIA": ([medium(), medium("mist", ".7, .7, .7"), container(where=LEFT), container(where=RIGHT, inside="mist")], [], None),
    "NONCONVEX_MEDIA": ([medium(), container("sphere")], [], None),
    "HETEROGENEOUS": ([grid_medium(1), container()], [], 1),
    "COLOURED_GRIDS": ([grid_medium(3), container()], [], 3),
    "SHORT_LIGHTS": ([medium(), container()], ["--short"], None),
    "DEPTH_LIMIT": ([medium(), container()], ["--max-depth", "8"], None),
}


def write(effect, folder):
    """Writes the scene of an effect; returns its file and the options that it is rendered with."""
    elements, options, grid = VARIANTS[effect]
    if grid:
        write_grid(folder, grid)
    scene = os.path.join(folder, "scene.xml")
    with open(scene, "w", encoding="utf-8") as file:
        file.write('<scene version="3.0.0">\n' + "\n".join([SENSOR, LAMP, *elements]) + "\n</scene>\n")
    return scene, options

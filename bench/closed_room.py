#!/usr/bin/env python3
"""closed_room.py PROGRAM [--rounds N] [--json FILE]: 1 / (relMSE x processor seconds) of what ray lights carry in a closed foggy room, and of path tracing of the same layers.

The room: a box of side 20 in isotropic fog of scattering .1 and absorption .01, a lamp of 6 x 6 under the ceiling, a diffuse sphere, the camera in front of an index-matched opening, 128 x 128 pixels.
relMSE as `tyndall compare` has it, against a render of another seed with 40 times the passes; one core. Start and compilation are left out: they are what a render of one pass takes beyond a pass.
"""
import argparse
import json
import os
import resource
import statistics
import subprocess
import tempfile

WALL = '  <shape type="rectangle"><transform name="to_world"><scale value="10"/>{turn}<translate {to}/></transform><ref id="{bsdf}"/></shape>'
WALLS = [('<rotate x="1" angle="-90"/>', 'y="-10"', "white"), ('<rotate x="1" angle="90"/>', 'y="10"', "white"), ("", 'z="-10"', "white"), ('<rotate y="1" angle="90"/>', 'x="-10"', "red"),
         ('<rotate y="1" angle="-90"/>', 'x="10"', "green")]
SCENE = """<scene version="3.0.0">
  <integrator type="volpath"><integer name="max_depth" value="-1"/></integrator>
  <medium type="homogeneous" id="fog"><float name="sigma_t" value="0.11"/><float name="albedo" value="0.90909090909"/><phase type="isotropic"/></medium>
  <bsdf type="diffuse" id="white"><rgb name="reflectance" value="0.73, 0.73, 0.73"/></bsdf>
  <bsdf type="diffuse" id="red"><rgb name="reflectance" value="0.63, 0.065, 0.05"/></bsdf>
  <bsdf type="diffuse" id="green"><rgb name="reflectance" value="0.14, 0.45, 0.09"/></bsdf>
  <sensor type="perspective">
    <float name="fov" value="38"/>
    <transform name="to_world"><lookat origin="0, 0, 38" target="0, 0, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="128"/><integer name="height" value="128"/><rfilter type="box"/></film>
    <sampler type="independent"/>
  </sensor>
  <shape type="cube"><transform name="to_world"><scale value="9.999"/></transform><bsdf type="null"/><ref name="interior" id="fog"/></shape>
%s
  <shape type="sphere"><point name="center" x="-3" y="-6" z="-2"/><float name="radius" value="3.9"/><ref id="white"/></shape>
  <shape type="rectangle"><transform name="to_world"><scale value="3"/><rotate x="1" angle="90"/><translate y="9.9"/></transform><ref id="white"/>
    <emitter type="area"><rgb name="radiance" value="10, 10, 10"/><ref id="fog"/></emitter></shape>
</scene>
""" % "\n".join(WALL.format(turn=turn, to=to, bsdf=bsdf) for turn, to, bsdf in WALLS)
LAYERS = "media_to_media,media_to_surface"


def render(program, folder, name, passes, seed, method):
    """Processor seconds of a render on one core."""
    command = [program, "render", os.path.join(folder, "room.xml"), "-o", os.path.join(folder, name), "--layer", LAYERS, "--method", method, "--passes", str(passes), "--seed", str(seed),
               "--threads", "1", "--progress", "none"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=os.environ | {"POCL_MAX_PTHREAD_COUNT": "1"})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def error_of(program, folder, name):
    result = subprocess.run([program, "compare", os.path.join(folder, name), os.path.join(folder, "reference.exr"), "--json"], check=False, capture_output=True, text=True)
    return json.loads(result.stdout)["relative_mse"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--passes", type=int, default=16)
    parser.add_argument("--json")
    wanted = parser.parse_args()
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "room.xml"), "w", encoding="utf-8") as file:
            file.write(SCENE)
        render(wanted.program, folder, "reference.exr", 40 * wanted.passes, 1000, "vrl")
        for method in ("vrl", "path"):
            start = min(2 * render(wanted.program, folder, "image.exr", 1, seed, method) - render(wanted.program, folder, "image.exr", 2, seed, method) for seed in (1, 2, 3))
            efficiency = []
            for i in range(wanted.rounds):
                seconds = render(wanted.program, folder, "image.exr", wanted.passes, 1 + i, method) - start
                efficiency.append(1 / (error_of(wanted.program, folder, "image.exr") * seconds))
            found[method] = {"median": statistics.median(efficiency), "low": min(efficiency), "high": max(efficiency), "rounds": wanted.rounds}
            print(f"{method:5s} {found[method]['median']:8.1f} ({found[method]['low']:.1f} - {found[method]['high']:.1f})", flush=True)
    if wanted.json:
        with open(wanted.json, "w", encoding="utf-8") as file:
            json.dump({"layers": LAYERS, "passes": wanted.passes, "efficiency": found}, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Tyndall beside Mitsuba 3's volumetric path tracers (volpath, volpathmis; LLVM, one thread) on the same scene files: see peers.sh.

For each scene the layer media_to_media and the whole image. Mitsuba has no layers: in a copy of the scene whose surfaces are black, its paths of any length less those of at most one
scattering, rendered with the same seed so that both share their first vertices, are that layer; only the time of the first counts. Each round renders everything twice, with seeds of
its own; relMSE of one render is half the squared difference of the two over ref^2 + (.05 mean)^2, where ref is the mean of all renders of the scene by all renderers; of means over 8 x 8
pixels likewise. What is told is the ratio of 1 / (relMSE x processor seconds), ours over theirs, as the median of the rounds with their range. Compilation and start are left out on both sides.
"""
import argparse
import json
import os
import re
import resource
import shutil
import statistics
import subprocess
import tempfile
import time

import numpy

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
SIZE = 96
# name: scene folder, definitions, what it stands for
SCENES = {
    "juice": ("fruit_juice", {}, "chromatic juice, nothing in the way"),
    "forward": ("forward_fog", {"g": "0.6", "sigma_t": "0.5"}, "forward fog, a block in the way"),
    "dense": ("forward_fog", {"g": "0", "sigma_t": "5"}, "dense isotropic fog, ten mean free paths"),
    "smoke": ("plume", {}, "a density grid"),
    "room": ("cornell_fog", {}, "closed room, thin isotropic fog"),
}
PEERS = ["volpath", "volpathmis"]


def prepared(folder, name, black, integrator):
    """A copy of the scene folder that both renderers read: film size, integrator and surfaces rewritten."""
    scene, definitions, _ = SCENES[name]
    target = os.path.join(folder, f"{name}_{'black' if black else 'full'}_{integrator}")
    if not os.path.exists(target):
        shutil.copytree(os.path.join(ROOT, "scenes", scene), target)
        file = os.path.join(target, "scene.xml")
        with open(file, encoding="utf-8") as stream:
            text = stream.read()
        for side in ("width", "height"):
            text = re.sub(rf'(<integer name="{side}" value=)"\d+"', rf'\1"{SIZE}"', text)
        text = re.sub(r'<integrator type="[^"]*"', f'<integrator type="{integrator}"', text, count=1)
        for key, value in definitions.items():
            text = re.sub(rf'(<default name="{key}" value=)"[^"]*"', rf'\1"{value}"', text)
        if black:
            text = re.sub(r'(<(?:rgb|spectrum|float) name="(?:specular_|diffuse_)?reflectance" value=)"[^"]*"', r'\1"0"', text)
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(text)
    return os.path.join(target, "scene.xml")


class Ours:
    name = "tyndall"

    def __init__(self, program, folder, name, layer):
        self.program, self.folder, self.layer = program, folder, layer
        self.scene = prepared(folder, name, layer is not None, "volpath")
        self.passes = 1
        self.start = min(self.run(1)[1] for _ in range(2))

    def run(self, seed):
        image = os.path.join(self.folder, "ours.exr")
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([self.program, "render", self.scene, "-o", image, "--passes", str(self.passes), "--seed", str(seed), "--threads", "1", "--progress", "none", *(["--layer", self.layer] if self.layer else [])],
                       check=True, stdout=subprocess.DEVNULL, env=os.environ | {"POCL_MAX_PTHREAD_COUNT": "1"})
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return image, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    def calibrate(self, seconds):
        self.passes, spent = 4, 0
        while spent < .25 * seconds:  # until the passes stand out from start and noise
            self.passes *= 4
            spent = self.run(1)[1] - self.start
        self.passes = max(2, round(self.passes * seconds / spent))

    def render(self, seed):
        image, seconds = self.run(seed)
        return read(image), (seconds - self.start) * self.passes / (self.passes - 1)


def read(file):
    import OpenEXR
    with OpenEXR.File(file) as exr:
        channels = exr.channels()
        for name in ("RGB", "RGBA"):
            if name in channels:
                return numpy.asarray(channels[name].pixels[..., :3], dtype=numpy.float64)
        return numpy.stack([channels[c].pixels for c in "RGB"], -1).astype(numpy.float64)


class Theirs:
    def __init__(self, folder, name, layer, integrator):
        import mitsuba
        self.mi, self.name, self.layer = mitsuba, integrator, layer
        file = prepared(folder, name, layer is not None, integrator)
        self.full = mitsuba.load_file(file)
        self.short = mitsuba.load_file(file, max_depth="2") if layer else None
        self.samples = 16
        self.image(self.full, 0)
        if self.short:
            self.image(self.short, 0)

    def image(self, scene, seed):
        start = time.process_time()
        image = numpy.array(self.mi.render(scene, spp=self.samples, seed=seed), dtype=numpy.float64)[..., :3]
        return image, time.process_time() - start

    def calibrate(self, seconds):
        per_sample = min(self.image(self.full, seed)[1] for seed in (1, 2)) / self.samples
        self.samples = max(2, round(seconds / per_sample))
        self.image(self.full, 3)  # another number of samples may be another kernel

    def render(self, seed):
        image, seconds = self.image(self.full, seed)
        return (image - self.image(self.short, seed)[0] if self.short else image), seconds


def blocks(image):
    return image.reshape(SIZE // 8, 8, SIZE // 8, 8, 3).mean((1, 3))


def relative_mse(a, b, ref, trimmed=False):
    terms = .5 * (a - b) ** 2 / (ref ** 2 + (.05 * ref.mean()) ** 2)
    if trimmed:
        terms = numpy.sort(terms.ravel())[:-max(1, terms.size // 1000)]
    return terms.mean()


def agreement(images):
    """Largest |z| of the mean of the image between ours and a peer's, from the spread of the renders."""
    means = {name: [image.mean() for image in all_of_one] for name, all_of_one in images.items()}
    error = lambda v: statistics.variance(v) / len(v)
    mean, own = statistics.mean(means["tyndall"]), error(means["tyndall"])
    return max(abs(mean - statistics.mean(v)) / (own + error(v)) ** .5 for name, v in means.items() if name != "tyndall")


def measure(arguments, folder, name, layer):
    renderers = [Ours(arguments.program, folder, name, layer)] + [Theirs(folder, name, layer, peer) for peer in PEERS]
    for renderer in renderers:
        renderer.calibrate(arguments.seconds)
    images, seconds = {r.name: [] for r in renderers}, {r.name: [] for r in renderers}
    for i in range(2 * arguments.rounds):
        for renderer in renderers if i % 2 == 0 else renderers[::-1]:
            image, spent = renderer.render(100 + i)
            images[renderer.name].append(image), seconds[renderer.name].append(spent)
    ref = numpy.mean([image for all_of_one in images.values() for image in all_of_one], 0)
    efficiency = {}
    for r in renderers:
        rounds = range(arguments.rounds)
        pair = lambda k: (images[r.name][2 * k], images[r.name][2 * k + 1])
        spent = [.5 * (seconds[r.name][2 * k] + seconds[r.name][2 * k + 1]) for k in rounds]
        efficiency[r.name] = {"pixels": [1 / (relative_mse(*pair(k), ref) * spent[k]) for k in rounds], "trimmed": [1 / (relative_mse(*pair(k), ref, True) * spent[k]) for k in rounds],
                              "blocks": [1 / (relative_mse(*map(blocks, pair(k)), blocks(ref)) * spent[k]) for k in rounds]}
    row = {"scene": name, "what": layer or "image", "z": agreement(images), "efficiency": efficiency, "ratios": {}}
    for peer in PEERS:
        row["ratios"][peer] = {}
        for kind in ("pixels", "trimmed", "blocks"):
            ratios = sorted(a / b for a, b in zip(efficiency["tyndall"][kind], efficiency[peer][kind]))
            row["ratios"][peer][kind] = {"median": statistics.median(ratios), "low": ratios[0], "high": ratios[-1]}
    print(f"{name:8} {row['what']:15} z {row['z']:.1f}  " + "  ".join(f"{peer}: {row['ratios'][peer]['pixels']['median']:.3g} pixels, {row['ratios'][peer]['blocks']['median']:.3g} means" for peer in PEERS), flush=True)
    return row


def markdown(result):
    text = ["# Beside Mitsuba 3", "", f"1 / (relMSE × processor seconds), Tyndall over Mitsuba {result['mitsuba']} on one core, {SIZE} × {SIZE} pixels; medians of {result['rounds']} rounds (lowest – highest). Above 1 Tyndall needs less time for the same error.",
            "", "| scene | | peer | pixels | trimmed | means over 8 × 8 | z of the means |", "|---|---|---|---|---|---|---|"]
    show = lambda r: f"{r['median']:.3g} ({r['low']:.3g} – {r['high']:.3g})"
    for row in result["rows"]:
        for peer in PEERS:
            ratios = row["ratios"][peer]
            text.append(f"| {row['scene']}: {SCENES[row['scene']][2]} | {row['what'].replace('_', ' ')} | {peer} | {show(ratios['pixels'])} | {show(ratios['trimmed'])} | {show(ratios['blocks'])} | {row['z']:.1f} |")
    text += ["", "In `media to media` rows both render the scene with black surfaces. Mitsuba's path tracers trace all layers with vectorised code; Tyndall path-traces what ray lights do not carry, so whole images in which light between walls rules are slower here.",
             "The ratios of that layer grow without bound as the fog gets thinner: paths that scatter twice become rare, connections do not."]
    return "\n".join(text) + "\n"


def main():
    global SIZE
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--seconds", type=float, default=3)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--size", type=int, default=SIZE, help="pixels along each side, a multiple of 8 (96)")
    parser.add_argument("--layers", default="media_to_media,image")
    parser.add_argument("--json")
    parser.add_argument("--markdown")
    arguments = parser.parse_args()
    SIZE = arguments.size
    import drjit
    import mitsuba
    mitsuba.set_variant("llvm_ad_rgb")
    drjit.set_thread_count(1)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name in arguments.scenes.split(","):
            for layer in [None if layer == "image" else layer for layer in arguments.layers.split(",")]:
                rows.append(measure(arguments, folder, name, layer))
    result = {"mitsuba": mitsuba.__version__, "rounds": arguments.rounds, "seconds": arguments.seconds, "size": SIZE, "rows": rows}
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(result, file, indent=1)
            file.write("\n")
    if arguments.markdown:
        with open(arguments.markdown, "w", encoding="utf-8") as file:
            file.write(markdown(result))


if __name__ == "__main__":
    main()

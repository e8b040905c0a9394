"""python_test.py EXAMPLE LIBRARY: runs the Python example and looks at what it says and writes. 77: there is no NumPy."""
import os
import re
import subprocess
import sys
import tempfile

try:
    import numpy  # noqa: F401
except ImportError:
    sys.exit(77)

with tempfile.TemporaryDirectory() as folder:
    image = os.path.join(folder, "fog.exr")
    ran = subprocess.run([sys.executable, "-B", sys.argv[1], image], env={**os.environ, "TYNDALL_LIBRARY": sys.argv[2]}, capture_output=True, text=True, timeout=240)
    if ran.returncode:
        sys.exit(f"the example failed:\n{ran.stdout}{ran.stderr}")
    said = re.fullmatch(r"64 x 48 pixels, mean ([\d.]+), of it scattered by the fog ([\d.]+), error ([\d.]+)%\n", ran.stdout)
    if not said:
        sys.exit(f"the example said something else: {ran.stdout!r}")
    mean, fog, error = map(float, said.groups())
    if not 0 < fog < mean or not 0 < error < 100:
        sys.exit(f"the example's numbers make no sense: {ran.stdout!r}")
    for ending, start in ((".exr", b"v/1\x01"), (".png", b"\x89PNG"), (".json", b"{")):
        with open(image[:-4] + ending, "rb") as file:
            if not file.read(4).startswith(start):
                sys.exit(f"fog{ending} is not what its name says")

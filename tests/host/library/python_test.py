"""python_test.py EXAMPLE LIBRARY: runs the Python example and looks at what it says, writes and shows. 77: there is no NumPy."""
import os
import re
import subprocess
import sys
import tempfile

try:
    import numpy
except ImportError:
    debian = "/usr/bin/python3"  # has Debian's NumPy, whatever else comes first on the path
    if os.path.exists(debian) and os.path.realpath(sys.executable) != os.path.realpath(debian):
        os.execv(debian, [debian, "-B", *sys.argv])
    sys.exit(77)

SHOWN = re.compile(r"\x1b\[38;2;(\d+);(\d+);(\d+);48;2;(\d+);(\d+);(\d+)m\u2580")


def run(folder, *arguments, modules):
    """What the example prints with these files among Python's modules, by name."""
    for name, text in modules.items():
        path = os.path.join(folder, "modules", name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)
    environment = {**os.environ, "TYNDALL_LIBRARY": sys.argv[2], "PYTHONPATH": os.path.join(folder, "modules"), "PYTHONIOENCODING": "utf-8"}
    ran = subprocess.run([sys.executable, "-B", sys.argv[1], *arguments], cwd=folder, env=environment, capture_output=True, encoding="utf-8", timeout=240)
    if ran.returncode:
        sys.exit(f"the example failed:\n{ran.stdout}{ran.stderr}")
    return ran.stdout


def expect(condition, what):
    if not condition:
        sys.exit(what)


def expect_a_picture(picture, what):
    """The fog is in the middle, brighter than the corners at the top, which are black."""
    expect(picture.shape == (48, 64, 3), f"{what}: {picture.shape}")
    expect(picture[:4, :4].max() == 0 and picture[20:28, 28:36].mean() > 20, f"{what}: this is not the box of fog")
    expect(picture.max() == 255, f"{what}: nothing is bright")


def files_and_terminal(folder):
    """Without Matplotlib: numbers, then the picture in characters."""
    said, _, shown = run(folder, "fog.exr", modules={"matplotlib/__init__.py": "raise ImportError('hidden by the test')"}).partition("\n")
    numbers = re.fullmatch(r"64 x 48 pixels, mean ([\d.]+), of it scattered by the fog ([\d.]+), error ([\d.]+)%", said)
    expect(numbers, f"the example said something else: {said!r}")
    mean, fog, error = map(float, numbers.groups())
    expect(0 < fog < mean and 0 < error < 100, f"the example's numbers make no sense: {said!r}")
    for ending, start in ((".exr", b"v/1\x01"), (".png", b"\x89PNG"), (".json", b"{")):
        with open(os.path.join(folder, "fog" + ending), "rb") as file:
            expect(file.read(4).startswith(start), f"fog{ending} is not what its name says")
    rows = [numpy.array(SHOWN.findall(line), int) for line in shown.splitlines()]
    picture = numpy.array([half for row in rows for half in (row[:, :3], row[:, 3:])])
    expect_a_picture(picture, "in the terminal")
    return picture


def window(folder):
    """With a Matplotlib that keeps what it is to show."""
    plot = "import numpy\ndef imshow(image):\n    numpy.save('asked.npy', image)\ndef show():\n    numpy.save('shown.npy', numpy.load('asked.npy'))\n"
    run(folder, modules={"matplotlib/__init__.py": "", "matplotlib/pyplot.py": plot})
    return numpy.load(os.path.join(folder, "shown.npy"))


with tempfile.TemporaryDirectory() as temporary:
    expect((files_and_terminal(temporary) == window(temporary)).all(), "window and terminal show different pictures")
    expect(run(temporary, "--no-show", modules={}).count("\n") == 1, "--no-show shows something")

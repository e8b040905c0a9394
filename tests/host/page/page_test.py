"""The page of `tyndall compare` in a real browser: page_test.py WRITE_PAGE [SCREENSHOTS]. Exit code 77: there is no browser here.

It opens a page of known content from the disk (write_page.cpp) and uses it as a reader would."""
import base64
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from browser import Browser


def choose(browser, selector, value):
    browser.run("const e = document.querySelector(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event(e.type === 'range' ? 'input' : 'change', {bubbles: true}));", selector, value)
    settle(browser)


def settle(browser):
    """Until the viewer has painted what was asked for."""
    browser.run("delete document.querySelector('#split').dataset.ready; dispatchEvent(new Event('beforeprint'));")
    browser.wait_for("document.querySelector('#split').dataset.ready")


def pixels(browser, selector):
    """[mean of red, green, blue of the left quarter, of the right quarter] of a canvas."""
    return browser.run("""
        const c = document.querySelector(arguments[0]), copy = Object.assign(document.createElement('canvas'), {width: c.width, height: c.height});
        const context = copy.getContext('2d', {willReadFrequently: true}), mean = (x, w) => {
          const d = context.getImageData(x, 0, w, c.height).data, sums = [0, 0, 0];
          for (let i = 0; i < d.length; ++i) if (i % 4 < 3) sums[i % 4] += d[i];
          return sums.map((s) => s / (d.length / 4));
        }, w = Math.floor(c.width / 4);
        context.drawImage(c, 0, 0);
        return [mean(0, w), mean(c.width - w, w)];""", selector)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        page = pathlib.Path(cls.folder.name)
        subprocess.run([write_page, str(page)], check=True)
        cls.data = json.loads((page / "comparison.json").read_text())
        cls.file = (page / "index.html").as_uri()
        cls.browser = Browser(driver, chromium)
        cls.browser.open(cls.file)
        cls.browser.wait_for("document.querySelector('#split').dataset.ready")

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.browser.wait_for("document.querySelector('#split').dataset.ready")

    def tearDown(self):
        self.assertEqual(self.browser.console(), [], "the console is silent")

    def names(self):
        return [c["name"] for c in self.data["candidates"]]

    def test_says_what_was_planted(self):
        rows = self.browser.run("return [...document.querySelectorAll('#equal tbody tr')].map((r) => r.innerText);")
        self.assertEqual([["biased" in row.split("%")[-1] for row in rows], ["in 3 of 3" in row for row in rows], ["no pass yet" in row for row in rows]],
                         [[False, True, False, False], [False, False, False, True], [False, False, True, False]], rows)
        self.assertIn("</script><b>a warning", self.browser.run("return document.querySelector('#warnings').innerText;"))
        self.assertIn("After 10 s, plain has the lowest error, 7.9 %", self.browser.run("return document.querySelector('#answer').innerText;"))

    def test_fetches_nothing(self):
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').map((e) => e.name).filter((n) => !n.startsWith('data:'));"), [])

    def test_curves_are_there(self):
        curves = self.browser.run("return [...document.querySelectorAll('#chart g[data-curve]')].map((g) => [g.dataset.curve, g.querySelector('.curve').getAttribute('d'), g.querySelectorAll('.error-bar').length]);")
        self.assertEqual([c[0] for c in curves], self.names())
        for (name, path, bars), candidate in zip(curves, self.data["candidates"]):
            self.assertEqual(path.count("L") + 1, len(candidate["curve"]), name)
            self.assertNotIn("NaN", path)
            self.assertEqual(bars, sum(at["relative_mse"] is not None for at in candidate["at_times"]), name)
            heights = [float(p.split(",")[1]) for p in path[1:].split("L")]
            self.assertGreater(heights[-1], heights[0], f"{name}: the error falls")

    def test_every_dial_has_its_curves_and_its_price(self):
        self.assertTrue(self.browser.run("return document.querySelector('#dials-section').hidden;"), "a comparison of all with all has none")
        self.browser.open(self.file.replace("index.html", "dials.html"))
        self.browser.wait_for("document.querySelector('#split').dataset.ready")
        curves = self.browser.run("return [...document.querySelectorAll('#dials .dial')].map((d) => [...d.querySelectorAll('g[data-curve]')].map((g) => [g.dataset.curve, g.querySelector('.curve').getAttribute('d')]));")
        self.assertEqual([[name for name, _ in dial] for dial in curves], [["plain", "biased", "slow start"], ["plain", "stray value"]])
        for _, path in sum(curves, []):
            self.assertNotIn("NaN", path)
            self.assertGreater(path.count("L"), 1)
        rows = self.browser.run("return [...document.querySelectorAll('#dials-table tbody tr')].map((r) => r.innerText);")
        self.assertEqual([[word for word in ("costs", "saves", "not told apart", "biased") if word in row] for row in rows], [["costs", "biased"], ["costs"], ["costs"]], rows)
        self.assertEqual(len(self.browser.run("return [...document.querySelectorAll('#chart g[data-curve]')];")), 3, "values of later dials start hidden")
        self.browser.open(self.file)

    def test_hover_reads_values(self):
        x, y, width, height = self.browser.box("#chart svg")
        last = self.browser.run("return Math.max(...[...document.querySelectorAll('#chart .wanted')].map((l) => l.getBoundingClientRect().x));")
        self.browser.point(("move", x + .4 * width, y + .5 * height), ("move", last, y + .5 * height))
        text = self.browser.run("const t = document.querySelector('.tip'); return t.hidden ? '' : t.innerText;")
        for name in self.names():
            self.assertIn(name, text)
        self.assertIn("%", text)

    def test_legend_hides_a_curve(self):
        self.browser.click("#legend button")
        self.assertEqual(self.browser.run("return document.querySelectorAll('#chart g[data-curve]').length;"), len(self.names()) - 1)
        self.browser.click("#legend button")

    def test_images_are_exact(self):
        means = self.browser.run("const i = await decode(data.reference.image); return [i.values.reduce((a, b) => a + b, 0) / i.values.length, i.width, i.height];")
        self.assertAlmostEqual(means[0] / self.data["reference"]["mean"], 1, delta=.0005)  # roundings of .2 % at most, and their mean
        self.assertEqual(means[1:], [self.data["width"], self.data["height"]])
        error = self.browser.run("""
            const r = await decode(data.reference.image), x = await decode(data.candidates[0].snapshots.at(-1).image), e = (.05 * data.reference.mean) ** 2;
            return x.values.reduce((sum, v, i) => sum + (v - r.values[i]) ** 2 / (r.values[i] ** 2 + e), 0) / x.values.length;""")
        self.assertAlmostEqual(error / self.data["candidates"][0]["snapshots"][-1]["relative_mse"], 1, delta=.01)

    def test_blocks_show_their_deviates(self):
        choose(self.browser, "#left", "0"), choose(self.browser, "#right", "reference"), choose(self.browser, "#mode", "blocks")
        left, right = pixels(self.browser, "#split canvas")
        self.assertEqual(len(self.data["candidates"][0]["bias"]["block_z"]), 9)  # 24 x 24 pixels
        self.assertNotEqual(left, right)
        self.browser.run("document.querySelector('#split .handle').dispatchEvent(new KeyboardEvent('keydown', {key: 'Home'}));")
        settle(self.browser)
        self.assertEqual([round(v) for v in pixels(self.browser, "#split canvas")[0]], [244, 243, 240])
        choose(self.browser, "#mode", "image"), choose(self.browser, "#right", "1")
        self.browser.run("const h = document.querySelector('#split .handle'); h.dispatchEvent(new KeyboardEvent('keydown', {key: 'Home'})); for (let i = 0; i < 25; ++i) h.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight'}));")

    def test_split_is_dragged(self):
        choose(self.browser, "#left", "reference"), choose(self.browser, "#mode", "difference"), choose(self.browser, "#right", "0")
        x, y, width, height = self.browser.box("#split")
        for share in (1, 0, .5):
            hx, hy, hw, hh = self.browser.box("#split .handle")
            self.browser.point(("move", hx + hw / 2, y + height / 3), ("down",), ("move", x + share * width, y + height / 3), ("up",))
            settle(self.browser)
            self.assertAlmostEqual(float(self.browser.run("return document.querySelector('#split').dataset.split;")), share, delta=.01)
            left, right = pixels(self.browser, "#split canvas")
            neutral = [244, 243, 240]  # the reference differs nowhere from itself
            self.assertEqual([round(v) for v in left] == neutral, share > 0, left)
            self.assertEqual([round(v) for v in right] == neutral, share == 1, right)
        choose(self.browser, "#mode", "image"), choose(self.browser, "#left", "0"), choose(self.browser, "#right", "1")

    def test_split_obeys_the_keyboard(self):
        self.browser.run("document.querySelector('#split .handle').focus();")
        self.browser.type("#split .handle", "\ue010")  # End
        settle(self.browser)
        self.assertEqual(self.browser.run("return document.querySelector('#split .handle').getAttribute('aria-valuenow');"), "100")
        self.browser.type("#split .handle", "\ue011" + "\ue014" * 25)  # Home, then right
        settle(self.browser)
        self.assertEqual(self.browser.run("return document.querySelector('#split .handle').getAttribute('aria-valuenow');"), "50")

    def test_zoom_is_locked_and_exposure_common(self):
        before = [pixels(self.browser, s) for s in ("#split canvas", "#strip tr:last-child canvas")]
        choose(self.browser, "#exposure", "2")
        brighter = [pixels(self.browser, s) for s in ("#split canvas", "#strip tr:last-child canvas")]
        for a, b in zip(before, brighter):
            self.assertGreater(b[0][0], a[0][0] + 5)
        choose(self.browser, "#exposure", "0")
        self.browser.click("#viewer-controls button[aria-label='zoom in']")
        settle(self.browser)
        self.assertEqual(self.browser.run("return document.querySelector('#split').dataset.zoom;"), "2")
        zoomed = [pixels(self.browser, s) for s in ("#split canvas", "#strip tr:last-child canvas")]
        for a, b in zip(before, zoomed):
            self.assertNotEqual(a, b)
        self.browser.click("#viewer-controls .buttons button:last-child")
        settle(self.browser)
        self.assertEqual([pixels(self.browser, s) for s in ("#split canvas", "#strip tr:last-child canvas")], before)

    def test_layers_can_be_seen(self):
        layers = self.browser.run("return [...document.querySelector('#layer').options].map((o) => o.value);")
        self.assertIn("single", layers)
        before = pixels(self.browser, "#split canvas")
        choose(self.browser, "#layer", "media_to_media")
        self.assertNotEqual(pixels(self.browser, "#split canvas"), before)
        choose(self.browser, "#layer", "image")

    def test_strip_sets_a_side(self):
        self.browser.click("#strip tr:last-child .sides button:first-child")
        settle(self.browser)
        self.assertEqual(self.browser.run("return document.querySelector('#left').value;"), "reference")
        choose(self.browser, "#left", "0")

    def test_tables_sort(self):
        for turn, wanted in ((1, "ascending"), (2, "descending")):
            self.browser.run("document.querySelectorAll('#numbers thead button')[1].click();")
            state = self.browser.run("return [document.querySelectorAll('#numbers th')[1].getAttribute('aria-sort'), [...document.querySelectorAll('#numbers tbody tr td:nth-child(2)')].map((d) => parseFloat(d.innerText))];")
            self.assertEqual(state[0], wanted, turn)
            self.assertEqual(state[1], sorted(state[1], reverse=turn == 2))

    def test_fits_a_phone_in_dark_and_light(self):
        for width, height, scheme in ((390, 844, "light"), (390, 844, "dark"), (320, 600, "light"), (1280, 900, "dark")):
            self.browser.develop("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=2, mobile=width < 600)
            self.browser.develop("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            settle(self.browser)
            wide, back = self.browser.run("return [document.documentElement.scrollWidth, getComputedStyle(document.body).backgroundColor];")
            self.assertLessEqual(wide, width, f"no horizontal scroll at {width} pixels")  # innerWidth would grow with the page on a phone
            red = int(back.split("(")[1].split(",")[0])
            self.assertEqual(red > 128, scheme == "light", back)
            if screenshots:
                size = self.browser.run("return document.documentElement.scrollHeight;")
                picture = self.browser.develop("Page.captureScreenshot", captureBeyondViewport=True, clip={"x": 0, "y": 0, "width": width, "height": size, "scale": 1})
                (screenshots / f"page_{width}_{scheme}.png").write_bytes(base64.b64decode(picture["data"]))
        self.browser.develop("Emulation.clearDeviceMetricsOverride")
        self.browser.develop("Emulation.setEmulatedMedia", features=[])
        settle(self.browser)

    def test_theme_button_turns_the_page(self):
        read = "return getComputedStyle(document.body).backgroundColor;"
        before = self.browser.run(read)
        self.browser.click("#theme")
        self.assertNotEqual(self.browser.run(read), before)
        self.browser.click("#theme")
        self.assertEqual(self.browser.run(read), before)

    def test_prints(self):
        self.assertGreater(len(self.browser.post("print")), 20000)


if __name__ == "__main__":
    write_page = sys.argv[1]
    screenshots = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    driver, chromium = shutil.which("chromedriver"), shutil.which("chromium")
    if not driver or not chromium:
        print("there is no chromedriver or no chromium (Debian: chromium chromium-driver), so the page is not tested")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)

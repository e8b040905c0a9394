"""A browser over the WebDriver protocol, with Python's standard library alone: chromedriver speaks HTTP and JSON."""
import json
import re
import subprocess
import time
import urllib.error
import urllib.request

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the protocol's name for a reference to an element


class Browser:
    """Headless Chromium; to be used in a `with` statement."""

    def __init__(self, driver, chromium, width=1280, height=900):
        self.process = subprocess.Popen([driver, "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        port = None
        for line in self.process.stdout:  # "ChromeDriver was started successfully on port 12345."
            if found := re.search(r"started successfully on port (\d+)", line):
                port = found.group(1)
                break
        self.address = f"http://127.0.0.1:{port}"
        arguments = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--force-device-scale-factor=1", f"--window-size={width},{height}"]
        options = {"browserName": "chrome", "goog:chromeOptions": {"binary": chromium, "args": arguments}, "goog:loggingPrefs": {"browser": "ALL"}}
        self.session = self._call("POST", "/session", {"capabilities": {"alwaysMatch": options}})["sessionId"]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self._call("DELETE", f"/session/{self.session}")
        finally:
            self.process.terminate()
            self.process.wait()

    def _call(self, method, path, body=None):
        request = urllib.request.Request(self.address + path, method=method, data=None if body is None else json.dumps(body).encode(), headers={"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from None

    def post(self, path, **body):
        return self._call("POST", f"/session/{self.session}/{path}", body)

    def open(self, address):
        self.post("url", url=address)

    def run(self, script, *arguments):
        """The value of `script`, the body of an async function."""
        return self.post("execute/async", script=f"const done = arguments[arguments.length - 1]; (async () => {{ {script} }})().then(done, (e) => done('failed: ' + e));", args=list(arguments))

    def wait_for(self, expression, seconds=20):
        end = time.monotonic() + seconds
        while not self.run(f"return Boolean({expression});"):
            if time.monotonic() > end:
                raise AssertionError(f"after {seconds} s this is still not so: {expression}")
            time.sleep(.05)

    def element(self, selector):
        return self.post("element", using="css selector", value=selector)[ELEMENT]

    def click(self, selector):
        self.post(f"element/{self.element(selector)}/click")

    def type(self, selector, text):
        self.post(f"element/{self.element(selector)}/value", text=text)

    def point(self, *steps):
        """Mouse: steps are ("move", x, y) in the window, ("down",) or ("up",)."""
        actions = [{"type": "pointerMove", "x": round(s[1]), "y": round(s[2]), "duration": 30} if s[0] == "move" else {"type": "pointer" + s[0].capitalize(), "button": 0} for s in steps]
        self.post("actions", actions=[{"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": actions}])

    def box(self, selector):
        """x, y, width, height in the window, after scrolling it there."""
        return self.run("const e = document.querySelector(arguments[0]); e.scrollIntoView({block: 'center'}); const b = e.getBoundingClientRect(); return [b.x, b.y, b.width, b.height];", selector)

    def develop(self, command, **parameters):
        return self.post("goog/cdp/execute", cmd=command, params=parameters)

    def console(self):
        return [entry["message"] for entry in self.post("se/log", type="browser")]

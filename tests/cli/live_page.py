# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `dewpoint-cli live --websocket` in headless Chromium: what it lists, what it draws, and that it sends nothing.
Arguments: the program, and Chromium. Runs in an empty folder, and leaves `page.png` there."""
import base64
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time
import unittest

CLI, CHROMIUM = sys.argv.pop(1), sys.argv.pop(1)
PATIENCE = 60  # seconds
# Runs before the page's own script: notes what is drawn and sent.
NOTES = """
window.drawn = {texts: new Set(), longest: {}, sent: 0};
const context = CanvasRenderingContext2D.prototype, fillText = context.fillText, stroke = context.stroke;
const beginPath = context.beginPath, lineTo = context.lineTo, send = WebSocket.prototype.send;
let points = 0;
context.fillText = function (text, ...at) { drawn.texts.add(text); return fillText.call(this, text, ...at); };
context.beginPath = function () { points = 0; return beginPath.call(this); };
context.lineTo = function (...at) { ++points; return lineTo.call(this, ...at); };
context.stroke = function () {
  drawn.longest[this.strokeStyle] = Math.max(drawn.longest[this.strokeStyle] || 0, points);
  return stroke.call(this);
};
WebSocket.prototype.send = function (...data) { ++drawn.sent; return send.call(this, ...data); };
"""
STATE = """JSON.stringify({
  status: document.getElementById("status").textContent, frames: Number(document.body.dataset.frames || 0),
  targets: [...document.querySelectorAll("#targets li")].map((row) => [...row.children].map((part) => part.textContent)),
  color: (document.querySelector("#targets .dot") || {style: {}}).style.background,
  texts: [...drawn.texts], longest: drawn.longest, sent: drawn.sent,
  controls: document.querySelectorAll("input, button, select, textarea, form, a").length})"""


class Browser:
    """Headless Chromium, which is told what to do by messages through a pipe."""

    def __init__(self):
        to_browser, self.requests = os.pipe()
        self.replies, from_browser = os.pipe()

        def be_pipes():  # Chromium reads from 3 and writes to 4
            spare = [os.dup(end) for end in (to_browser, from_browser)]  # neither is overwritten first
            os.dup2(spare[0], 3)
            os.dup2(spare[1], 4)

        self.process = subprocess.Popen(
            [CHROMIUM, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
             f"--user-data-dir={os.getcwd()}/profile", "--window-size=900,600", "--remote-debugging-pipe", "about:blank"],
            preexec_fn=be_pipes, close_fds=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, env={**os.environ, "HOME": os.getcwd()})
        for end in (to_browser, from_browser):
            os.close(end)
        self.timer = threading.Timer(2 * PATIENCE, self.process.kill)
        self.timer.start()
        self.rest = b""
        self.count = 0
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]

    session = None

    def ask(self, method, **parameters):
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.requests, json.dumps(message).encode() + b"\0")
        while True:
            while b"\0" not in self.rest:
                data = os.read(self.replies, 1 << 16)
                if not data:
                    raise RuntimeError("Chromium has ended")
                self.rest += data
            reply, self.rest = self.rest.split(b"\0", 1)
            reply = json.loads(reply)
            if reply.get("id") == self.count:
                if "error" in reply:
                    raise RuntimeError(f"{method}: {reply['error']}")
                return reply["result"]

    def open(self, address):
        self.ask("Page.enable")
        self.ask("Page.addScriptToEvaluateOnNewDocument", source=NOTES)
        self.ask("Page.navigate", url=address)

    def state(self):
        result = self.ask("Runtime.evaluate", expression=STATE)["result"]
        return json.loads(result["value"]) if "value" in result else None  # not loaded yet

    def wait(self, holds):
        """The first state of which this is true; the last one if it takes too long."""
        deadline = time.monotonic() + PATIENCE
        while True:
            state = self.state()
            if (state and holds(state)) or time.monotonic() > deadline:
                return state
            time.sleep(0.1)

    def close(self):
        self.timer.cancel()
        self.process.kill()
        self.process.wait()
        os.close(self.requests)
        os.close(self.replies)


class Page(unittest.TestCase):
    def setUp(self):
        self.browser = Browser()
        self.addCleanup(self.browser.close)

    def start(self, project):
        live = subprocess.Popen([CLI, "live", project, "--websocket", "0"], stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, text=True)
        self.addCleanup(live.stdout.close)
        self.addCleanup(live.wait)
        self.addCleanup(live.send_signal, signal.SIGINT)
        return live, re.search(r"http://\S+", live.stdout.readline()).group(0)

    def test_shows_cameras_targets_and_tracks(self):
        live, address = self.start("demo")
        self.browser.open(address)
        state = self.browser.wait(lambda now: now["frames"] > 90 and any(row[3] for row in now["targets"])
                                  and any(name.startswith("camera") for name in now["texts"]))
        self.assertIsNotNone(state)
        self.assertRegex(state["status"], r"^Frame \d+, [\d.]+ s$")
        self.assertEqual(len(state["targets"]), 1)
        _, name, word, place = state["targets"][0]
        self.assertEqual((name, word), ("pink ball", "tracking"))
        self.assertRegex(place, r"^-?\d\.\d{3}  -?\d\.\d{3}  -?\d\.\d{3} m$")
        for position, center in zip(map(float, place.split()[:3]), (0.5, 0.5, 0.15)):
            self.assertLess(abs(position - center), 0.2)  # the ball stays within 0.12 m of it
        for text in ("camera 1", "camera 2", "pink ball"):
            self.assertIn(text, state["texts"])
        # The track: a line of many points in the color of the target.
        red, green, blue = map(int, re.findall(r"\d+", state["color"]))
        self.assertGreater(state["longest"].get(f"#{red:02x}{green:02x}{blue:02x}", 0), 30, state["longest"])
        self.assertEqual((state["sent"], state["controls"]), (0, 0))  # it only reads
        picture = base64.b64decode(self.browser.ask("Page.captureScreenshot")["data"])
        pathlib.Path("page.png").write_bytes(picture)
        live.send_signal(signal.SIGINT)
        state = self.browser.wait(lambda now: now["status"].startswith("Not connected"))
        self.assertEqual(state["status"], "Not connected. Trying again…")

    def test_names_are_texts(self):
        hostile = '<img src=x onerror=\\"drawn.sent=99\\">'
        pathlib.Path("hostile.toml").write_text(
            'format = 2\nscene = "demo"\nmethod = "dewpoint"\n[[target]]\n'
            f'name = "{hostile}"\nradius = 0.035\nhue = [300, 335]\n')
        _, address = self.start("hostile.toml")
        self.browser.open(address)
        state = self.browser.wait(lambda now: now["frames"] > 5)
        self.assertEqual(state["targets"][0][1], hostile.replace('\\"', '"'))
        self.assertEqual(state["sent"], 0)


if __name__ == "__main__":
    unittest.main()

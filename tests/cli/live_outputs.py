# SPDX-License-Identifier: GPL-3.0-or-later
"""Every output of `dewpoint-cli live`, read by the clients of the manual's page and by others. Arguments: the program, and
the page. Runs in an empty folder."""
import base64
import json
import os
import pathlib
import re
import signal
import socket
import stat
import struct
import subprocess
import sys
import threading
import time
import unittest

CLI, PAGE = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1)).read_text()
CLIENTS = dict(zip(("tcp", "websocket", "osc"), re.findall(r"^```python\n(.*?)^```", PAGE, re.S | re.M)))
TOKEN = "open sesame"
PATIENCE = 60  # seconds


def free_port(kind=socket.SOCK_DGRAM):
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Live:
    """A running program. The first lines that it prints are where the results go."""

    def __init__(self, *arguments, places=1, project="demo"):
        self.process = subprocess.Popen([CLI, "live", project, *arguments], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.places = [self.process.stdout.readline().strip() for _ in range(places)]

    def port(self, words):
        place = next(place for place in self.places if words in place)
        return int(re.search(r":(\d+)/?$", place).group(1))

    def stop(self):
        self.process.send_signal(signal.SIGINT)
        return self.wait()

    def wait(self):
        out, err = self.process.communicate(timeout=PATIENCE)
        return self.process.returncode, out, err

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
            self.process.communicate()


class Client:
    """A client of the page, at other ports."""

    def __init__(self, name, port):
        code = re.sub(r"\b900[0-9]\b", str(port), CLIENTS[name])
        self.process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, text=True)

    def line_with(self, *words):
        """The first line with all of these words; an empty one if the client ends."""
        timer = threading.Timer(PATIENCE, self.process.kill)
        timer.start()
        try:
            return next((line for line in self.process.stdout if all(word in line for word in words)), "")
        finally:
            timer.cancel()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.communicate()


def connected(port):
    return socket.create_connection(("127.0.0.1", port), PATIENCE)


def ask(stream, **command):
    """The reply to a remote command over TCP."""
    stream.write(json.dumps(command) + "\n")
    stream.flush()
    return next(message for message in map(json.loads, stream) if message["type"] == "reply")


def open_web_socket(port, message=b""):
    connection = connected(port)
    key = base64.b64encode(os.urandom(16))
    connection.sendall(b"GET / HTTP/1.1\r\nHost: localhost:%d\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                       b"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: %s\r\n\r\n" % (port, key) + message)
    return connection


class Outputs(unittest.TestCase):
    def test_the_clients_of_the_page_get_the_results(self):
        self.assertEqual(len(CLIENTS), 3)
        osc, tuio = free_port(), free_port()
        tuio_receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        tuio_receiver.bind(("127.0.0.1", tuio))
        tuio_receiver.settimeout(PATIENCE)
        with Client("osc", osc) as osc_client, Live(
                "--tcp", "0", "--websocket", "0", "--osc", f"127.0.0.1:{osc}", "--tuio", f"127.0.0.1:{tuio}", "--csv",
                "all.csv", "--unit", "mm", "--out", "all", places=5) as live:
            tcp, web = live.port("JSON lines"), live.port("WebSocket")
            with Client("tcp", tcp) as tcp_client, Client("websocket", web) as web_client:
                self.assertRegex(tcp_client.line_with("ball", "["), r"^[\d.]+ .*ball \[-?\d")
                self.assertRegex(web_client.line_with("ball", "["), r"^[\d.]+ .*ball \[-?\d")
            self.assertRegex(osc_client.line_with("/dewpoint/target"), r"^/dewpoint/target 1 .*ball held -?\d")
            self.assertRegex(osc_client.line_with("/dewpoint/frame"), r"^/dewpoint/frame \d+ \d+ [\d.]+ \d+$")
            bundle = tuio_receiver.recv(65536)
            self.assertTrue(bundle.startswith(b"#bundle\0") and b"/tuio/3Dcur" in bundle and b"fseq" in bundle)
            deadline = time.monotonic() + PATIENCE
            while len(pathlib.Path("all.csv").read_text().splitlines()) <= 12 and time.monotonic() < deadline:
                time.sleep(0.1)
            code, out, err = live.stop()
        tuio_receiver.close()
        self.assertEqual((code, err), (0, ""))
        self.assertIn("frames sent", out)
        rows = pathlib.Path("all.csv").read_text().splitlines()
        self.assertTrue(rows[0].startswith("time_s,frame,id,target,state,x_mm,"))
        self.assertGreater(len(rows), 10)
        self.assertIn(",held,", rows[-1])
        for name in ("trajectory.csv", "run.json", "truth.csv"):
            self.assertTrue(pathlib.Path("all", name).stat().st_size > 0, name)
        # What was sent is what was tracked.
        frame = rows[-1].split(",")[1]
        written = next(row.split(",") for row in pathlib.Path("all/trajectory.csv").read_text().splitlines()
                       if re.match(rf"[\d.]+,{frame},", row))
        for sent, kept in zip(rows[-1].split(",")[5:8], written[3:6]):
            self.assertAlmostEqual(float(sent) / 1000, float(kept), places=6)

    def test_standard_output_has_nothing_but_rows(self):
        done = subprocess.run([CLI, "live", "demo", "--seconds", "2", "--csv", "-"], capture_output=True, text=True,
                              timeout=PATIENCE)
        self.assertEqual(done.returncode, 0)
        rows = done.stdout.splitlines()
        self.assertGreater(len(rows), 5)
        self.assertEqual({row.count(",") for row in rows}, {rows[0].count(",")})
        self.assertIn("CSV lines to standard output", done.stderr)

    def test_a_recording_plays_at_its_pace_and_ends(self):
        begin = time.monotonic()
        code, out, _ = (live := Live("--seconds", "3", "--out", "paced", places=0)).wait()
        live.process.stdout.close()
        self.assertEqual(code, 0)
        self.assertGreater(time.monotonic() - begin, 3)
        frames = int(re.search(r"^frames +(\d+)", out, re.M).group(1))
        self.assertTrue(20 < frames < 200, frames)

    def test_a_named_pipe_serves_one_reader_after_another(self):
        os.mkfifo("pipe")
        self.assertTrue(stat.S_ISFIFO(os.stat("pipe").st_mode))
        with Live("--csv", "pipe") as live:
            for _ in range(2):
                with open("pipe") as reader:
                    self.assertTrue(reader.readline().startswith("time_s,"))
                    self.assertIn("ball", reader.readline())
                time.sleep(1)  # until it shows that the reader has gone
            self.assertEqual(live.stop()[0], 0)

    def test_hostile_input_changes_nothing(self):
        with Live("--tcp", "0", "--websocket", "0", places=2) as live:
            tcp, web = live.port("JSON lines"), live.port("WebSocket")
            half_open = [connected(port) for port in (tcp, web) for _ in range(20)]
            for port in (tcp, web):
                for junk in (b"x" * (1 << 20), os.urandom(1 << 16), b"\0" * 5000, b"GET " + b"/" * 100_000,
                             b"{" * 100_000 + b"\n", b"\n" * 10_000):
                    with connected(port) as bad:
                        try:
                            bad.sendall(junk)
                        except OSError:
                            pass  # it was thrown out before the end
            # A message that claims to have 2^62 bytes, and one that is not masked.
            for message in (b"\x81\xff" + struct.pack(">Q", 1 << 62) + b"\0" * 4, b"\x81\x02hi"):
                open_web_socket(web, message).close()
            deaf = connected(tcp)  # never reads
            with Client("tcp", tcp) as client, Client("websocket", web) as other:
                self.assertTrue(client.line_with("ball"))
                self.assertTrue(other.line_with("ball"))
            code, _, err = live.stop()
            self.assertEqual((code, err), (0, ""))
            for connection in (*half_open, deaf):
                connection.close()

    def test_remote_commands_need_the_token(self):
        pathlib.Path("token.txt").write_text(TOKEN + "\n")
        with Live("--tcp", "0", "--out", "remote", "--token-file", "token.txt") as live:
            with connected(live.port("JSON lines")) as connection, connection.makefile("rw") as stream:
                self.assertTrue(ask(stream, command="record", name="jump-3", token=TOKEN)["ok"])
                self.assertFalse(ask(stream, command="record", name="again", token=TOKEN)["ok"])
                for message in map(json.loads, stream):
                    if message["type"] == "frame" and message["frame"] > 20:
                        break
                self.assertTrue(ask(stream, command="stop-recording", token=TOKEN)["ok"])
                self.assertTrue(ask(stream, command="stop", token=TOKEN)["ok"])
                time.sleep(0.5)
                self.assertTrue(ask(stream, command="start", token=TOKEN)["ok"])
                self.assertIn("name", ask(stream, command="record", name="../x", token=TOKEN)["error"])
                for _ in range(5):
                    self.assertIn("wrong", ask(stream, command="stop", token="guess")["error"])
                self.assertIn("too many", ask(stream, command="stop", token=TOKEN)["error"])
            self.assertEqual(live.stop()[0], 0)
        take = [row for row in pathlib.Path("remote/jump-3.csv").read_text().splitlines() if row[0].isdigit()]
        whole = pathlib.Path("remote/trajectory.csv").read_text().splitlines()
        self.assertTrue(take and set(take) <= set(whole))
        self.assertEqual(len(take), len(set(take)))
        self.assertLess(len(take), len([row for row in whole if row[0].isdigit()]))

    def test_mistakes_are_explained(self):
        pathlib.Path("short.txt").write_text("abc\n")
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = str(taken.getsockname()[1])
            for arguments, code, words in (
                    ((), 2, ("--tcp",)), (("--tcp", port), 3, ("--tcp", port)), (("--tcp", "70000"), 2, ("--tcp",)),
                    (("--websocket", port), 3, ("--websocket", port)), (("--osc", "nowhere"), 3, ("--osc", "HOST:PORT")),
                    (("--csv", "/nowhere/at/all.csv"), 5, ("--csv",)), (("--axes", "x-up", "--tcp", "0"), 2, ("--axes",)),
                    (("--tcp", "0", "--token-file", "short.txt"), 3, ("--token-file", "8")),
                    (("--tcp", "0", "--token-file", "none.txt"), 3, ("none.txt",))):
                with self.subTest(arguments=arguments):
                    done = subprocess.run([CLI, "live", "demo", *arguments], capture_output=True, text=True,
                                          timeout=PATIENCE)
                    self.assertEqual(done.returncode, code, done.stderr)
                    for word in words:
                        self.assertIn(word, done.stderr)

    def test_a_project_says_where_results_go(self):
        pathlib.Path("live.toml").write_text('format = 2\nscene = "demo"\nmethod = "dewpoint"\n[[target]]\nname = "ball"\n'
                                             'radius = 0.035\nhue = [300, 335]\n[output]\ntcp = 0\ncsv = "of project.csv"\n'
                                             'axes = "y-up"\n')
        with Live(project="live.toml", places=2) as live:
            with connected(live.port("JSON lines")) as connection, connection.makefile() as stream:
                self.assertEqual(json.loads(stream.readline())["axes"], "y-up")
            self.assertEqual(live.stop()[0], 0)
        self.assertTrue(pathlib.Path("of project.csv").is_file())


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Tracking from Python gives the bits of the command line, frame by frame or in one call."""

import csv
import gc
import signal
import sys
import threading
import time
import unittest

import numpy

import dewpoint
from support import InFolder, cli

FRAMES = 8


def demo(method="dewpoint"):
    project = dewpoint.open("demo")
    project.method = method
    return project


def fed(project, order="bgr", copy=False):
    """The positions of a Tracker that is fed with the project's own images."""
    tracker = dewpoint.Tracker(project)
    recording = project.recording()
    positions = []
    for number in range(FRAMES):
        frames = recording[number]
        images = frames.images
        if order == "rgb":
            images = [image[:, :, ::-1] for image in images]
        (estimate,) = tracker.step(images, frames.time, order=order, copy=copy)
        positions.append(estimate.position)
    return numpy.array(positions)


class SameBits(InFolder):
    def check(self, method, threads):
        project = demo(method)
        cli("track", "demo", "--method", method, "--frames", f"0:{FRAMES}", "--out", "by_cli")
        run = project.track(frames=(0, FRAMES), threads=threads)
        run.save("by_python.csv")
        with open("by_cli/trajectory.csv", "rb") as one, open("by_python.csv", "rb") as other:
            self.assertEqual(one.read(), other.read())
        written = dewpoint.read_trajectory("by_cli/trajectory.csv")
        numpy.testing.assert_array_equal(written[0].positions, run[0].positions)
        numpy.testing.assert_array_equal(written[0].covariances, run[0].covariances)
        numpy.testing.assert_array_equal(written.frames, run.frames)
        self.assertEqual(written.header["method"], method)

    def test_method_dewpoint(self):
        self.check("dewpoint", 1)

    def test_method_barrera_on_two_threads(self):
        self.check("barrera", 2)

    def test_frames_one_by_one(self):
        for method in ("dewpoint", "barrera"):
            project = demo(method)
            positions = project.track(frames=(0, FRAMES))[0].positions
            numpy.testing.assert_array_equal(fed(project), positions)
            numpy.testing.assert_array_equal(fed(project, copy=True), positions)
            numpy.testing.assert_array_equal(fed(project, order="rgb"), positions)

    def test_parameters_and_seed(self):
        project = demo("barrera")
        project.parameters["particles"] = 60
        project.seed = 7
        cli("track", "demo", "--method", "barrera", "--particles", "60", "--seed", "7",
            "--frames", "2:6", "--out", "by_cli")
        run = project.track(frames=(2, 6))
        written = dewpoint.read_trajectory("by_cli/trajectory.csv")
        numpy.testing.assert_array_equal(written[0].positions, run[0].positions)
        self.assertEqual(list(run.frames), [2, 3, 4, 5])

    def test_boxes(self):
        cli("track", "one-camera", "--frames", "0:4", "--out", "by_cli")
        with open("by_cli/boxes.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        project = dewpoint.open("one-camera")
        boxes = project.track(frames=(0, 4)).boxes(0)
        self.assertEqual(boxes["boxes"].shape, (4, 4))
        self.assertEqual(boxes["frames"].tolist(), [int(row["frame"]) for row in rows])
        self.assertEqual(boxes["similarity"].tolist(), [float(row["similarity"]) for row in rows])
        tracker = dewpoint.Tracker(project)
        frames = project.recording()[0]
        (estimate,) = tracker.step(frames.images, frames.time)
        self.assertIsNone(estimate.position)
        self.assertEqual(estimate.box, tuple(boxes["boxes"][0]))


class Arrays(unittest.TestCase):
    def test_shapes_and_values(self):
        run = demo().track(frames=(0, FRAMES), particles=50)
        track = run["pink ball"]
        self.assertEqual(run.targets, ["pink ball"])
        self.assertEqual(run.times.shape, (FRAMES,))
        self.assertEqual(track.positions.shape, (FRAMES, 3))
        self.assertEqual(track.covariances.shape, (FRAMES, 3, 3))
        numpy.testing.assert_array_equal(track.covariances,
                                         track.covariances.transpose(0, 2, 1))
        self.assertEqual(track.valid.dtype, bool)
        self.assertTrue(((track.existence >= 0) & (track.existence <= 1)).all())
        self.assertTrue(run.finished)
        self.assertEqual(run.frame_count, FRAMES)
        positions, weights = run.particles("pink ball", 3)
        self.assertEqual(positions.shape, (len(weights), 3))
        self.assertTrue(0 < len(weights) <= 50)
        with self.assertRaises(KeyError):
            run.particles("pink ball", FRAMES)
        with self.assertRaises(KeyError):
            run["green ball"]
        with self.assertRaises(IndexError):
            run[1]

    def test_they_outlive_what_they_are_of(self):
        run = demo("barrera").track(frames=(0, 3), particles=20)
        positions = run[0].positions
        weights = run.particles(0, 1)[1]
        values, shares = positions.tolist(), weights.tolist()
        del run
        gc.collect()
        self.assertEqual(positions.tolist(), values)
        self.assertEqual(weights.tolist(), shares)
        with self.assertRaises(ValueError):
            positions[0, 0] = 1.0

    def test_images_are_not_copied(self):
        frames = demo().recording()[2]
        first, again = frames.images[0], frames.images[0]
        self.assertEqual(first.ctypes.data, again.ctypes.data)
        self.assertEqual(first.dtype, numpy.uint8)
        self.assertFalse(first.flags.writeable)
        total = int(first.sum())
        del frames, again
        gc.collect()
        self.assertEqual(int(first.sum()), total)

    def test_images_fed_are_held_not_copied(self):
        project = demo("barrera")
        images = [image.copy() for image in project.recording()[0].images]
        before = sys.getrefcount(images[0])
        tracker = dewpoint.Tracker(project)
        tracker.step(images, 0.0)
        self.assertGreater(sys.getrefcount(images[0]), before)
        positions, weights = tracker.particles("pink ball")
        self.assertEqual(positions.shape, (len(weights), 3))
        self.assertAlmostEqual(float(weights.sum()), 1.0, places=9)
        del tracker
        gc.collect()
        self.assertEqual(sys.getrefcount(images[0]), before)

    def test_several_targets(self):
        project = demo("barrera")
        (ball,) = project.targets
        project.targets = [ball, ball.replace(name="twin", radius=0.02)]
        run = project.track(frames=(0, 3))
        self.assertEqual(run.targets, ["pink ball", "twin"])
        self.assertEqual(run["twin"].positions.shape, (3, 3))
        tracker = dewpoint.Tracker(project)
        frames = project.recording()[0]
        estimates = tracker.step(frames.images, frames.time)
        self.assertEqual([one.target for one in estimates], ["pink ball", "twin"])
        numpy.testing.assert_array_equal(estimates[1].position, run["twin"].positions[0])
        tracker.restart()
        self.assertEqual(tracker.steps, 0)

    def test_evaluation_against_the_truth(self):
        project = demo()
        (found,) = project.track(frames=(0, 30)).evaluate(project.truth())
        self.assertEqual(found.target, "pink ball")
        self.assertLess(found.rmse, 0.03)  # the gate within which it counts as found


class Progress(unittest.TestCase):
    def test_told_before_each_frame_and_at_the_end(self):
        told = []
        demo().track(frames=(0, 3), progress=lambda *what: told.append(what))
        self.assertEqual(told, [(0, 3), (1, 3), (2, 3), (3, 3)])

    def test_false_ends_the_run_and_keeps_it(self):
        run = demo().track(progress=lambda done, total: done < 2)
        self.assertFalse(run.finished)
        self.assertEqual(len(run.frames), 2)

    def test_an_exception_comes_through(self):
        def fail(done, total):
            raise RuntimeError(f"at {done}")

        with self.assertRaisesRegex(RuntimeError, "at 0"):
            demo().track(progress=fail)

    def test_ctrl_c(self):
        def press(done, total):
            if done == 2:
                signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            demo().track(progress=press)

    def test_other_threads_go_on_meanwhile(self):
        project = demo()
        counted, done = [0], threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1
                time.sleep(0)

        worker = threading.Thread(target=count)
        worker.start()
        try:
            for _ in range(20):  # a busy machine may let the other thread wait
                before = counted[0]
                project.track(frames=(0, 10))
                if counted[0] > before + 10:
                    return
            self.fail("the other thread stood still")
        finally:
            done.set()
            worker.join()


if __name__ == "__main__":
    unittest.main()

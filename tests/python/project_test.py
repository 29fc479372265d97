# SPDX-License-Identifier: GPL-3.0-or-later
"""Projects from Python: opened, changed, saved; errors in the sentences of the command line."""

import os
import unittest
import warnings

import numpy

import dewpoint
from support import InFolder, cli, run_cli


class Opening(InFolder):
    def test_a_built_in_scene(self):
        project = dewpoint.open("demo")
        self.assertEqual((project.name, project.method, project.file), ("demo", "dewpoint", None))
        self.assertEqual([camera.name for camera in project.cameras], ["camera 1", "camera 2"])
        self.assertEqual([target.name for target in project.targets], ["pink ball"])
        self.assertEqual(len(project.recording()), project.recording().frame_count)

    def test_cameras(self):
        camera = dewpoint.open("demo").cameras[0]
        self.assertEqual(camera.size, (320, 240))
        self.assertFalse(camera.fisheye)
        self.assertEqual(camera.distortion.shape, (8,))
        # Both axes of the rig meet in this point: it is at the image's center.
        (pixel,) = camera.project(numpy.array([[0.5, 0.5, 0.15]]))
        numpy.testing.assert_allclose(pixel, [159.5, 119.5], atol=1e-6)
        numpy.testing.assert_allclose(camera.matrix[:2, 2], [159.5, 119.5])
        # The pose takes the center to the origin.
        at_origin = camera.camera_from_world @ numpy.append(camera.center, 1.0)
        numpy.testing.assert_allclose(at_origin, [0, 0, 0, 1], atol=1e-12)
        self.assertTrue(numpy.isnan(camera.project(camera.center[None] - [0, 1, 0])).all())

    def test_what_is_saved_is_read_again(self):
        project = dewpoint.open("demo")
        project.method = "barrera"
        project.parameters["particles"] = 70
        project.seed = 5
        project.name = "mine"
        project.volume = ((0, 0, 0), (1, 1, 0.5))
        color = ((300, 335), (0.25, 1), (0.1, 0.9))
        project.targets = [dewpoint.Target("ball", radius=0.03, colors=[color], shape="ball")]
        with self.assertRaises(dewpoint.Error):
            project.save()
        project.save("mine.toml")
        again = dewpoint.open("mine.toml")
        self.assertEqual((again.name, again.method, again.seed), ("mine", "barrera", 5))
        self.assertEqual(again.parameters["particles"], 70)
        self.assertEqual(again.volume, ((0, 0, 0), (1, 1, 0.5)))
        self.assertEqual(again.targets, project.targets)
        self.assertEqual(again.targets[0].colors, [color])
        self.assertEqual(again.targets[0].shape, "ball")
        again.seed = 6
        again.save()
        self.assertEqual(dewpoint.open("mine.toml").seed, 6)
        cli("track", "mine.toml", "--frames", "0:2", "--out", "run")

    def test_made_of_videos(self):
        cli("simulate", "demo", "--frames", "3", "--out", "made")
        videos = {"left": "made/camera-1.mkv", "right": "made/camera-2.mkv"}
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            guessed = dewpoint.make(videos)
        self.assertIn("guesses", str(caught[0].message))
        self.assertEqual([camera.name for camera in guessed.cameras], ["left", "right"])
        with self.assertWarnsRegex(UserWarning, "order"):
            project = dewpoint.make(videos, calibration="made/calibration.toml", name="made")
        self.assertEqual(project.cameras[1].size, (240, 320))
        self.assertEqual([frames.index for frames in project.recording()], [0, 1, 2])
        (last,) = [frames for frames in project.recording() if frames.index == 2]
        self.assertAlmostEqual(last.time, 2 / project.recording().frames_per_second, places=8)
        self.assertEqual(project.recording()[-1].images[1].shape, (320, 240, 3))


class Methods(unittest.TestCase):
    def test_the_catalog_and_the_documentation_are_the_declarations(self):
        methods = dewpoint.methods()
        self.assertEqual(methods[0].name, "dewpoint")
        for method in methods:
            self.assertIn(method.sentence, dewpoint.Project.method.__doc__)
            for parameter in method.parameters:
                self.assertIn(f"{parameter.key}: ", method.reference)
                self.assertIn(parameter.sentence, dewpoint.Parameters.__doc__)

    def test_parameters_are_a_mapping(self):
        project = dewpoint.open("demo")
        project.method = "barrera"
        (barrera,) = [method for method in dewpoint.methods() if method.name == "barrera"]
        parameters = project.parameters
        self.assertEqual(list(parameters), [one.key for one in barrera.parameters])
        self.assertEqual(len(parameters), len(barrera.parameters))
        self.assertIn("particles", parameters)
        self.assertNotIn("number", parameters)
        usual = dict(parameters)["particles"]
        self.assertIsInstance(usual, int)
        parameters["particles"] = usual + 1
        self.assertEqual(project.parameters["particles"], usual + 1)
        parameters.reset("particles")
        self.assertEqual(dict(parameters.items())["particles"], usual)


class Errors(InFolder):
    def check(self, arguments, action):
        """The command line and Python say the same sentence."""
        said = run_cli(*arguments)
        self.assertNotEqual(said.returncode, 0)
        with self.assertRaises(dewpoint.Error) as caught:
            action()
        lines = [line for line in said.stderr.splitlines() if not line.startswith("[")]  # FFmpeg's
        self.assertEqual(lines, [f"dewpoint-cli: {caught.exception}"])
        return caught.exception

    def track(self, name):
        return self.check(["track", name, "--out", "run"], lambda: dewpoint.open(name).track())

    def write(self, name, *lines):
        with open(name, "w", encoding="utf-8") as file:
            file.write("\n".join(["format = 2", 'scene = "demo"', *lines, ""]))

    def test_of_project_files(self):
        error = self.track("gone.toml")
        self.assertEqual(error.code, dewpoint.ErrorCode.FILE_MISSING)
        self.assertEqual(error.file, "gone.toml")
        self.assertIsNone(error.result)
        self.write("key.toml", "colour = 3")
        self.track("key.toml")
        self.write("method.toml", 'method = "condensation"')
        self.assertEqual(self.track("method.toml").field, "method")
        self.write("value.toml", "[parameters]", "particles = -1")
        self.track("value.toml")
        self.write("empty.toml")
        self.assertEqual(self.track("empty.toml").field, "target")

    def test_of_recordings(self):
        cli("simulate", "demo", "--frames", "3", "--out", "made")
        cli("new", "videos.toml", "--camera", "camera 1=made/camera-1.mkv", "--camera",
            "camera 2=made/camera-2.mkv", "--calibration", "made/calibration.toml")
        cli("learn-color", "videos.toml", "--pixel", "157,117", "--out", "taught.toml")
        with open("made/camera-2.mkv", "wb") as video:
            video.write(b"no video")
        self.track("taught.toml")

    def test_of_a_recording_that_breaks_off(self):
        cli("simulate", "smooth", "--frames", "20", "--out", "scene")
        # The file announces its frames at its start, so half of it ends before its own end.
        video = "scene/camera-1.mkv"
        os.truncate(video, os.path.getsize(video) // 2)
        error = self.track("scene/project.toml")
        self.assertEqual(error.code, dewpoint.ErrorCode.ENDED_EARLY)
        self.assertFalse(error.result.finished)
        self.assertEqual(error.result.frame_count, len(error.result.times))
        self.assertTrue(0 < error.result.frame_count < 20)
        written = dewpoint.read_trajectory("run/trajectory.csv")
        numpy.testing.assert_array_equal(written[0].positions, error.result[0].positions)

    def test_of_arguments(self):
        project = dewpoint.open("demo")
        with self.assertRaisesRegex(dewpoint.Error, "known methods: dewpoint"):
            project.method = "condensation"
        with self.assertRaisesRegex(dewpoint.Error, "particles"):
            project.parameters["particles"] = 0
        with self.assertRaisesRegex(dewpoint.Error, "number"):
            project.parameters["number"] = 1
        with self.assertRaisesRegex(dewpoint.Error, "number"):
            project.parameters["number"]
        with self.assertRaisesRegex(dewpoint.Error, "radius"):
            project.targets = [dewpoint.Target("ball", radius=-1.0)]
        with self.assertRaisesRegex(dewpoint.Error, "shape"):
            dewpoint.Target("ball", shape="cube")
        with self.assertRaisesRegex(dewpoint.Error, "frames"):
            project.track(frames=(3, 3))
        with self.assertRaises(IndexError):
            project.recording()[100000]
        self.assertEqual([target.name for target in project.targets], ["pink ball"])

    def test_of_images(self):
        project = dewpoint.open("demo")
        images = project.recording()[0].images
        tracker = dewpoint.Tracker(project)
        for wrong, said in [(images[:1], "one per camera"), ([None, None], "no camera"),
                            ([images[1], images[0]], "camera 1 is 240x320"),
                            ([images[0].astype(float), images[1]], "uint8"),
                            ([images[0][:, :, 0], images[1]], "height x width x 3"), (["a", 1], "uint8")]:
            with self.assertRaisesRegex(dewpoint.Error, said):
                tracker.step(wrong, 0.0)
        with self.assertRaisesRegex(dewpoint.Error, "order"):
            tracker.step(images, 0.0, order="hsv")
        with self.assertRaisesRegex(dewpoint.Error, "time"):
            tracker.step(images, float("nan"))
        tracker.step([images[0], None], 0.5)
        with self.assertRaisesRegex(dewpoint.Error, "does not come after"):
            tracker.step(images, 0.5)
        self.assertEqual(tracker.steps, 1)


if __name__ == "__main__":
    unittest.main()

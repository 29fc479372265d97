# SPDX-License-Identifier: GPL-3.0-or-later
"""What is set up before a run: colors from clicks, calibrations of other tools, boards."""

import unittest

import numpy

import dewpoint
from support import InFolder, cli, run_cli


class FromVideos(InFolder):
    def setUp(self):
        super().setUp()
        cli("simulate", "demo", "--frames", "5", "--out", "made")
        cli("new", "fresh.toml", "--camera", "camera 1=made/camera-1.mkv", "--camera",
            "camera 2=made/camera-2.mkv", "--calibration", "made/calibration.toml")

    def test_a_color_as_the_command_line_learns_it(self):
        # The ball rests in the center of both images.
        cli("learn-color", "fresh.toml", "--camera", "camera 1", "--frame", "2", "--pixel",
            "157,117", "--more", "camera 2:3:119,159", "--exclude", "camera 1:0:10,10", "--target",
            "pink ball", "--radius", "0.035", "--out", "by_cli.toml")
        project = dewpoint.open("fresh.toml")
        lesson = project.learn_color(
            "camera 1", 2, pixel=(157, 117), more=[("camera 2", 3, (119, 159))],
            exclude=[(0, 0, (10, 10))], target="pink ball", radius=0.035)
        project.save("by_python.toml")
        with open("by_cli.toml", "rb") as one, open("by_python.toml", "rb") as other:
            self.assertEqual(one.read(), other.read())
        self.assertEqual(lesson.target, project.targets[0])
        self.assertGreater(lesson.score, 50)
        (camera, x, y), = [found for found in lesson.found if found[0] == "camera 2"]
        self.assertLess(numpy.hypot(x - 119.5, y - 159.5), 24)  # its radius there, in pixels
        self.assertEqual(len(project.track()[0].positions), 5)

    def test_a_box_around_the_target(self):
        project = dewpoint.open("fresh.toml")
        lesson = project.learn_color(1, 0, box=(95, 135, 50, 50), shape="ball")
        self.assertEqual(lesson.target.name, "target 1")
        self.assertEqual(lesson.target.shape, "ball")

    def test_errors_of_clicks(self):
        said = run_cli("learn-color", "fresh.toml", "--pixel", "400,10").stderr
        project = dewpoint.open("fresh.toml")
        with self.assertRaises(dewpoint.Error) as caught:
            project.learn_color(0, 0, pixel=(400, 10))
        # The argument is called otherwise.
        self.assertEqual(said.replace("--pixel", "pixel"), f"dewpoint-cli: {caught.exception}\n")
        for arguments, field in [({"camera": 2}, "camera"), ({"frame": 5}, "frame"),
                                 ({"frame": -1}, "frame"), ({"box": (0, 0, 9, 9)}, "pixel"),
                                 ({"shape": "cube"}, "shape")]:
            with self.assertRaises(dewpoint.Error) as caught:
                project.learn_color(**{"pixel": (157, 117), **arguments})
            self.assertEqual(caught.exception.field, field)
        self.assertEqual(project.targets, [])

    def test_formats_of_other_tools(self):
        project = dewpoint.open("fresh.toml")
        centers = [camera.center for camera in project.cameras]
        for name, file, unit in [("dewpoint", "c.toml", None), ("anipose", "a.toml", "mm"),
                                 ("kalibr", "c.yaml", None)]:
            other = dewpoint.open("fresh.toml")
            self.assertTrue(project.export_calibration(file, format=name, replace=True))
            imported = other.import_calibration(file, format=name, unit=unit)
            self.assertTrue(imported.decisions)
            self.assertFalse(imported.lens_only)
            apart = [numpy.linalg.norm(camera.center - other.cameras[0].center)
                     for camera in other.cameras]
            expected = [numpy.linalg.norm(center - centers[0]) for center in centers]
            numpy.testing.assert_allclose(apart, expected, atol=1e-6)

    def test_errors_of_calibrations(self):
        with open("broken.json", "w", encoding="utf-8") as file:
            file.write("{}")
        said = run_cli("calibration", "convert", "broken.json", "other.toml").stderr
        project = dewpoint.open("fresh.toml")
        with self.assertRaises(dewpoint.Error) as caught:
            project.import_calibration("broken.json")
        self.assertEqual(said, f"dewpoint-cli: {caught.exception}\n")
        with self.assertRaisesRegex(dewpoint.Error, "unit"):
            project.import_calibration("broken.json", unit="parsec")
        with self.assertRaisesRegex(dewpoint.Error, "fit"):
            project.import_calibration("broken.json", fit="stretch")

    def test_what_does_not_fit_is_adapted(self):
        project = dewpoint.open("fresh.toml")
        names = [camera.name for camera in project.cameras]
        project.export_calibration("other.toml", format="dewpoint", replace=True)
        with open("other.toml", encoding="utf-8") as file:
            text = file.read().replace(f'"{names[0]}"', '"first"')
        with open("other.toml", "w", encoding="utf-8") as file:
            file.write(text)
        with self.assertRaises(dewpoint.Error):
            dewpoint.open("fresh.toml").import_calibration("other.toml")
        other = dewpoint.open("fresh.toml")
        other.import_calibration("other.toml", names={names[0]: "first"})
        numpy.testing.assert_allclose(other.cameras[0].center, project.cameras[0].center,
                                      atol=1e-9)
        with self.assertRaisesRegex(dewpoint.Error, "fit"):
            dewpoint.make({"a": "made/camera-1.mkv"}, calibration="other.toml", fit="stretch")


class Boards(InFolder):
    def test_a_recording_without_a_board(self):
        said = run_cli("calibrate", "intrinsics", "demo", "--looks", "3", "--board",
                       "chessboard:9x6:0.025").stderr
        project = dewpoint.open("demo")
        parts = []
        with self.assertRaises(dewpoint.Error) as caught:
            project.calibrate_board("chessboard:9x6:0.025", poses=False, looks=3,
                                    progress=parts.append)
        self.assertEqual(said, f"dewpoint-cli: {caught.exception}\n")
        self.assertTrue(parts and all(0.0 <= part <= 1.0 for part in parts))

    def test_arguments(self):
        project = dewpoint.open("demo")
        for arguments, field in [({"board": "checker:9x6:0.025"}, "board"), ({"model": "6"}, "model"),
                                 ({"lenses": False, "poses": False}, "lenses")]:
            with self.assertRaises(dewpoint.Error) as caught:
                project.calibrate_board(**{"board": "chessboard:9x6:0.025", **arguments})
            self.assertEqual(caught.exception.field, field)
        with self.assertRaises(dewpoint.Error) as caught:
            project.calibrate_board("chessboard:9x6:0.025", progress=lambda part: False)
        self.assertEqual(caught.exception.code, dewpoint.ErrorCode.CANCELED)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Tracks colored objects in 3D with particle filters.

    import dewpoint

    project = dewpoint.open("demo")                  # a project file, or a built-in scene
    run = project.track(frames=(0, 60))              # the same bits as dewpoint-cli track
    print(run.times, run["pink ball"].positions)     # NumPy arrays: seconds, meters

Positions are in meters in the world of the calibration, times in seconds, images are arrays of
height x width x 3, blue green red. What goes wrong is a dewpoint.Error with the sentence of the
command line.
"""

from ._dewpoint import (
    BoardCalibration,
    CalibrationImport,
    Camera,
    ColorLesson,
    Error,
    ErrorCode,
    Estimate,
    Evaluation,
    Frames,
    Method,
    Parameter,
    Parameters,
    Project,
    Recording,
    Run,
    Target,
    Track,
    Tracker,
    Trajectory,
    __version__,
    make,
    methods,
    open,
    read_trajectory,
)

__all__ = [
    "BoardCalibration",
    "CalibrationImport",
    "Camera",
    "ColorLesson",
    "Error",
    "ErrorCode",
    "Estimate",
    "Evaluation",
    "Frames",
    "Method",
    "Parameter",
    "Parameters",
    "Project",
    "Recording",
    "Run",
    "Target",
    "Track",
    "Tracker",
    "Trajectory",
    "__version__",
    "make",
    "methods",
    "open",
    "read_trajectory",
]

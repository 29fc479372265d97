// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle/fault.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace dewpoint::calibration {

const char* faultName(CalibrationFault fault) {
  static constexpr std::array<const char*, 12> kNames{
      "mirrored-board",     "millimeters-mixed", "inches-mixed", "cameras-swapped",
      "wrong-square-count", "wrong-square-size", "half-pixel",   "camera-late",
      "camera-moved",       "video-flipped",     "zoom-changed", "wrong-resolution"};
  return kNames.at(static_cast<std::size_t>(fault));
}

std::string faultDescription(const DetectedFault& fault,
                             const std::vector<std::string>& cameraNames) {
  const auto name = [&](std::size_t k) {
    return k < fault.cameras.size() ? cameraNames.at(fault.cameras[k]) : std::string("all cameras");
  };
  switch (fault.fault) {
  case CalibrationFault::MirroredBoard:
    return "All cameras seem to see the board from behind, or the floor from below: the measured "
           "points are probably mirrored. Check the direction of the axes, and make sure that the "
           "printed board is not mirrored.";
  case CalibrationFault::WrongUnitMillimeters:
    return fmt::format("The given length is {:.3g} times the length that the cameras see: "
                       "millimeters and meters are probably mixed up. Give all lengths in meters.",
                       fault.value);
  case CalibrationFault::WrongUnitInches:
    return fmt::format("The given length is {:.3g} times the length that the cameras see: it is "
                       "probably in inches. Give it in meters (1 inch = 0.0254 m).",
                       fault.value);
  case CalibrationFault::CamerasSwapped:
    return fmt::format("Everything fits when {} and {} are exchanged: their videos are probably "
                       "swapped. Exchange the two files.",
                       name(0), name(1));
  case CalibrationFault::WrongSquareCount:
    return fmt::format("The corners form a board with {:.0f} squares in a row, so the given number "
                       "of squares is probably wrong. Count the squares and correct the number.",
                       fault.value);
  case CalibrationFault::WrongSquareSize:
    return fmt::format("The given size of the squares is {:.3g} times the size that the cameras "
                       "see. Measure a row with a ruler: prints are often rescaled.",
                       fault.value);
  case CalibrationFault::HalfPixel:
    return fmt::format("The images fit only if they are shifted by {:+.1f} px along both axes: the "
                       "calibration probably counts pixel coordinates from the corner of the first "
                       "pixel, not from its center. Convert the principal points.",
                       fault.value);
  case CalibrationFault::CameraDelayed:
    return fmt::format("{} agrees with the other cameras only if its video is shifted in time: the "
                       "video is probably {:.0f} frames {}. Synchronize the videos, or set late_by "
                       "of this camera in the project file.",
                       name(0), std::abs(fault.value), fault.value > 0.0 ? "late" : "early");
  case CalibrationFault::CameraMoved:
    return fmt::format(
        "The images of {} fit one pose before {:.1f} s and another pose after that time: the "
        "camera was probably moved. Calibrate with the later part of the recording only.",
        name(0), fault.value);
  case CalibrationFault::VideoFlipped:
    return fmt::format(
        "The images of {} fit only if they are flipped: the video is probably mirrored or upside "
        "down. Set rotate and mirror of this camera in the project file.",
        name(0));
  case CalibrationFault::ZoomChanged:
    return fmt::format(
        "The images of {} fit a focal length that is {:.3g} times the one in its calibration: the "
        "zoom or crop of the camera was probably changed. Calibrate its intrinsics again.",
        name(0), fault.value);
  case CalibrationFault::WrongResolution:
    return fmt::format("The images of {} are {:.3g} times as large as those for which it was "
                       "calibrated: its intrinsics are for another resolution. Convert the "
                       "intrinsics, or record at the calibrated size.",
                       name(0), fault.value);
  }
  return {};
}

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Common mistakes in a calibration.
enum class CalibrationFault {
  /// One axis of the points (as entered or printed) is reversed, or the floor is mirrored.
  MirroredBoard,
  WrongUnitMillimeters, ///< a length is a thousand times too large or small
  WrongUnitInches,      ///< a length was entered in inches as if it were in another unit
  CamerasSwapped,       ///< the videos of two cameras are exchanged
  WrongSquareCount,     ///< the number of squares in a row differs from the one entered
  WrongSquareSize,      ///< the size of the squares differs from the one entered
  HalfPixel,            ///< image points or principal points are half a pixel off in all cameras
  CameraDelayed,        ///< one video is shifted in time relative to the others, by whole frames
  CameraMoved,          ///< a camera was moved at some time
  VideoFlipped,         ///< a video is mirrored or upside down
  ZoomChanged,          ///< the focal length differs from the calibrated one
  WrongResolution       ///< the intrinsics are for another image size
};

/// Fault that explains the observations clearly better than assuming no fault.
struct DetectedFault {
  CalibrationFault fault = CalibrationFault::CamerasSwapped;
  std::vector<std::size_t> cameras = {}; ///< affected cameras; empty: all cameras, or none
  /// Number that describes the fault. What it means depends on the fault: the delay in frames, the
  /// time (seconds) at which the camera was moved, the ratio of the given focal length or size to
  /// the one that was found, the number of columns that was found, or a distance in pixels. 0 if no
  /// number describes the fault.
  double value = 0.0;
  /// Log likelihood of the observations with this fault, minus that without any fault; 0 if the
  /// fault was not found by its residuals.
  double logLikelihoodGain = 0.0;
  std::string sentence = {}; ///< likely cause, and advice for the user
};

/// Returns the name of a fault as used in files, which never changes, for example "mirrored-board".
const char* faultName(CalibrationFault fault);

/// Returns a sentence about a fault: the likely cause, and advice. It refers to cameras by name.
std::string faultDescription(const DetectedFault& fault,
                             const std::vector<std::string>& cameraNames);

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// What people do wrong when they calibrate.
enum class CalibrationFault {
  MirroredBoard,    ///< or floor: one axis of the typed or printed points is the wrong way round
  MillimetersMixed, ///< a length a thousand times too large or small
  InchesMixed,      ///< a length in inches
  CamerasSwapped,   ///< the videos of two cameras exchanged
  WrongSquareCount, ///< another number of squares in a row than typed
  WrongSquareSize,
  HalfPixel,      ///< image points or principal points half a pixel off, in all cameras
  CameraLate,     ///< one video begins frames earlier or later than the others
  CameraMoved,    ///< a camera stood elsewhere from some time on
  VideoFlipped,   ///< mirrored, or upside down
  ZoomChanged,    ///< another focal length than calibrated
  WrongResolution ///< lens data of another image size
};

/// A fault that explains what is seen clearly better than its absence.
struct NamedFault {
  CalibrationFault fault = CalibrationFault::CamerasSwapped;
  std::vector<std::size_t> cameras = {}; ///< those concerned; empty: all, or none
  /// Frames late; seconds when the camera moved; ratio of focal lengths, sizes, given over found
  /// length; columns found; pixels. 0 where there is nothing to count.
  double value = 0.0;
  double gain = 0.0; ///< log-likelihood gained by it; 0 where it is no question of residuals
  std::string sentence = {}; ///< likely cause, and what to do
};

/// The stable name of a fault: "mirrored-board" ...
const char* faultName(CalibrationFault fault);

/// Cause and advice, with the cameras by name.
std::string faultSentence(const NamedFault& fault, const std::vector<std::string>& cameraNames);

} // namespace dewpoint::calibration

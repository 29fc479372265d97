// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Common mistakes in a calibration.
enum class CalibrationFault {
  MirroredBoard,    ///< or mirrored floor: one axis of the entered or printed points is reversed
  MillimetersMixed, ///< a length a thousand times too large or small
  InchesMixed,      ///< a length in inches
  CamerasSwapped,   ///< the videos of two cameras exchanged
  WrongSquareCount, ///< the number of squares in a row differs from the one entered
  WrongSquareSize,
  HalfPixel,      ///< image points or principal points half a pixel off, in all cameras
  CameraLate,     ///< one video is shifted in time against the others, by whole frames
  CameraMoved,    ///< a camera was moved at some time
  VideoFlipped,   ///< mirrored, or upside down
  ZoomChanged,    ///< the focal length differs from the calibrated one
  WrongResolution ///< lens data is for another image size
};

/// A fault that explains the observations clearly better than no fault.
struct NamedFault {
  CalibrationFault fault = CalibrationFault::CamerasSwapped;
  std::vector<std::size_t> cameras = {}; ///< cameras concerned; empty: all, or none
  /// Size of the fault: delay in frames; time of a camera motion in seconds; ratio of focal lengths
  /// or of sizes (given over found length); number of columns found; pixels. 0 if the fault has no
  /// size.
  double value = 0.0;
  double gain = 0.0;         ///< gain in log likelihood; 0 if it does not follow from residuals
  std::string sentence = {}; ///< likely cause, and what to do
};

/// Stable name of a fault: "mirrored-board" ...
const char* faultName(CalibrationFault fault);

/// Sentence with cause and advice, with the cameras by name.
std::string faultSentence(const NamedFault& fault, const std::vector<std::string>& cameraNames);

} // namespace dewpoint::calibration

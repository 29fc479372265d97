// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::setup {

/// Quality of the knowledge about a part of the calibration.
enum class KnowledgeLevel {
  Missing, ///< only guessed by the program, or known to be wrong
  Given,   ///< entered, set by hand or read from a file; its accuracy was not measured
  Measured ///< found by measurement with this program, and not changed since
};

/// Status of one part of the calibration.
struct ItemStatus {
  KnowledgeLevel knowledge = KnowledgeLevel::Missing;
  /// Origin of this part; empty if it is not recorded.
  std::optional<CalibrationOrigin> origin = {};
  /// Error of this part; its meaning and unit differ from part to part; empty if unknown.
  std::optional<double> error = {};
  /// True if this part was measured, but with such low accuracy that it should be measured again.
  bool isPoor = false;

  bool operator==(const ItemStatus&) const = default;
};

/// Calibration status of one camera.
struct CameraCalibrationStatus {
  ItemStatus lens; ///< status of the intrinsics; the error is in pixels (LensRecord::error)
  ItemStatus pose; ///< status of the pose; the error is in meters (PoseRecord::error)
  double delaySeconds = 0.0; ///< delay of the images (ProjectCamera::delay), seconds
};

/// Calibration status of a project.
struct CalibrationStatus {
  std::vector<CameraCalibrationStatus> cameras; ///< status of each camera, in project order
  ItemStatus scale;      ///< status of the scale; the error is relative (WorldRecord::scaleError)
  ItemStatus floor;      ///< status of the floor and the upward direction, without an error
  bool isUpright = true; ///< false if the images show that the z axis does not point up
  /// Error, in meters, that 95 % of the positions measured in the calibrated volume do not exceed
  /// (WorldRecord::errorInsideVolume).
  std::optional<double> errorInVolume;
  /// Error, in meters, that 95 % of the positions outside the calibrated volume do not exceed, if
  /// at least two cameras see them (WorldRecord::errorOutsideVolume).
  std::optional<double> errorOutsideVolume;
  /// Comparison of a measured with a calibrated length, if the user made one.
  std::optional<LengthCheck> lengthCheck;
};

/// Returns the calibration status of a project. Records about values that have changed since are
/// ignored. Simulated cameras are known exactly: their status is Measured, without an origin.
CalibrationStatus calibrationStatus(const Project& project);

/// Returns the origin of a part of the calibration in a few English words, for example "guessed" or
/// "board".
const char* originText(const ItemStatus& part);

/// Returns the number of cameras for which a part of the calibration (intrinsics or pose) is known
/// at least to the level `least`. A part that was measured with poor accuracy (`isPoor`) counts as
/// Given, not as Measured.
std::size_t countKnownCameras(const CalibrationStatus& status,
                              ItemStatus CameraCalibrationStatus::*part, KnowledgeLevel least);

/// Returns the largest error of a part of the calibration (intrinsics or pose) among all cameras;
/// empty if no error is known.
std::optional<double> worstError(const CalibrationStatus& status,
                                 ItemStatus CameraCalibrationStatus::*part);

} // namespace dewpoint::setup

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <array>
#include <optional>

namespace dewpoint::project {

/// Input from which a part of a calibration was computed.
enum class CalibrationOrigin {
  Points, ///< points measured in the room and clicked in the images
  Board,  ///< views of a printed board
  Wand,   ///< views of a waved ball or stick
  File,   ///< file of another tool
  Marks   ///< points marked in the images to define the floor or a measured distance
};

/// How the intrinsics of a camera were determined, and how accurate they are.
struct LensRecord {
  CalibrationOrigin origin = CalibrationOrigin::File;
  /// Image error that is caused by inexact intrinsics: the standard deviation, in pixels, of the
  /// projection of a given direction, where it is largest in the image. Empty if unknown.
  std::optional<double> error;
  /// Intrinsics that the record describes: the two focal lengths and the principal point, pixels.
  std::array<double, 4> describedIntrinsics{};

  bool operator==(const LensRecord&) const = default;
};

/// How the pose of a camera was determined, and how accurate it is.
struct PoseRecord {
  CalibrationOrigin origin = CalibrationOrigin::File;
  /// Standard deviation of the camera position relative to the other cameras, meters. Empty if
  /// unknown.
  std::optional<double> error;
  /// Pose that the record describes: the camera's center in the world frame (meters), then the
  /// rotation vector (camera from world, radians).
  std::array<double, 6> describedPose{};

  bool operator==(const PoseRecord&) const = default;
};

/// How a camera was calibrated, and how accurate the calibration is. Each of the two records
/// (intrinsics and pose) contains a copy of the calibration values that it describes. A record
/// becomes invalid as soon as the calibration of the camera differs from this copy.
struct CameraRecord {
  std::optional<LensRecord> lens;
  std::optional<PoseRecord> pose;

  bool operator==(const CameraRecord&) const = default;
};

/// A distance in the room, in meters: measured by the user, for example with a tape, and computed
/// with the calibration from clicks on its two ends in the images.
struct LengthCheck {
  double measuredLength = 0.0;
  double calibratedLength = 0.0;

  bool operator==(const LengthCheck&) const = default;
};

/// How the world frame of a project was determined, and how accurate it is.
struct WorldRecord {
  /// Input that determined the scale; empty if unknown.
  std::optional<CalibrationOrigin> scaleOrigin;
  /// Relative error of the scale: with a probability of 95 %, the true error is at most this value.
  /// Empty if unknown.
  std::optional<double> scaleError;
  /// Input that determined where the floor is; empty if unknown.
  std::optional<CalibrationOrigin> floorOrigin;
  /// Error, in meters, that 95 % of the positions measured in the calibrated volume do not exceed.
  std::optional<double> errorInsideVolume;
  /// Error, in meters, that 95 % of the positions outside the calibrated volume do not exceed, if
  /// at least two cameras see them. The value is extrapolated.
  std::optional<double> errorOutsideVolume;
  /// Comparison of a measured with a calibrated length, if the user made one.
  std::optional<LengthCheck> lengthCheck;

  bool operator==(const WorldRecord&) const = default;
};

/// Creates the record of the current intrinsics of a camera. `origin` and `error` are stored in the
/// record.
LensRecord recordOfLens(const Camera& camera, CalibrationOrigin origin,
                        std::optional<double> error = {});
/// Creates the record of the current pose of a camera. `origin` and `error` are stored in the
/// record.
PoseRecord recordOfPose(const Camera& camera, CalibrationOrigin origin,
                        std::optional<double> error = {});

/// Returns whether a record of intrinsics is still valid: its values equal the current intrinsics
/// of the camera, within the precision of a project file.
bool describes(const LensRecord& record, const Camera& camera);
/// Returns whether a record of a pose is still valid: its values equal the current pose of the
/// camera, within the precision of a project file.
bool describes(const PoseRecord& record, const Camera& camera);

} // namespace dewpoint::project

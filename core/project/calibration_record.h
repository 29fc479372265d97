// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <array>
#include <optional>

namespace dewpoint::project {

/// Where a part of a calibration comes from.
enum class CalibrationOrigin {
  Points, ///< points measured in the room and clicked in the images
  Board,  ///< views of a printed board
  Wand,   ///< views of a waved ball or stick
  File,   ///< file of another tool
  Marks   ///< points marked in the images to define the floor or a measured distance
};

/// Where the intrinsics of a camera come from.
struct LensRecord {
  CalibrationOrigin origin = CalibrationOrigin::File;
  /// Standard deviation of a projected ray at the place in the image where it is largest, pixels.
  /// Empty if unknown.
  std::optional<double> error;
  /// Intrinsics that the record describes: the two focal lengths and the principal point, pixels.
  std::array<double, 4> of{};

  bool operator==(const LensRecord&) const = default;
};

/// Where the pose of a camera comes from.
struct PoseRecord {
  CalibrationOrigin origin = CalibrationOrigin::File;
  /// Standard deviation of the camera position relative to the other cameras, meters. Empty if
  /// unknown.
  std::optional<double> error;
  /// Pose that the record describes: the camera's center in the world frame (meters), then the
  /// rotation vector (camera from world, radians).
  std::array<double, 6> of{};

  bool operator==(const PoseRecord&) const = default;
};

/// Where the calibration of a camera comes from. Each record stores the calibration values that it
/// describes. It is no longer valid if the calibration differs from these values, no matter who
/// changed them.
struct CameraRecord {
  std::optional<LensRecord> lens;
  std::optional<PoseRecord> pose;

  bool operator==(const CameraRecord&) const = default;
};

/// A distance in the room, as measured with a tape and as found from marks in the images. Meters.
struct LengthCheck {
  double measured = 0.0;
  double found = 0.0;

  bool operator==(const LengthCheck&) const = default;
};

/// Where the world frame of a project comes from.
struct WorldRecord {
  std::optional<CalibrationOrigin> scale;
  /// Relative error of the scale that is not exceeded with a probability of 95 %.
  std::optional<double> scaleError;
  std::optional<CalibrationOrigin> floor;
  /// Position error, in meters, that is not exceeded at 95 % of the positions in the calibrated
  /// volume.
  std::optional<double> accuracy;
  std::optional<LengthCheck> check;

  bool operator==(const WorldRecord&) const = default;
};

/// Returns a record for the present intrinsics of a camera.
LensRecord recordOfLens(const Camera& camera, CalibrationOrigin origin,
                        std::optional<double> error = {});
/// Returns a record for the present pose of a camera.
PoseRecord recordOfPose(const Camera& camera, CalibrationOrigin origin,
                        std::optional<double> error = {});

/// Returns whether the values in a record equal the present intrinsics or pose of a camera, within
/// the precision of a project file.
bool isAbout(const LensRecord& record, const Camera& camera);
bool isAbout(const PoseRecord& record, const Camera& camera);

} // namespace dewpoint::project

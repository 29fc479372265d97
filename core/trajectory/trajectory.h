// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::trajectory {

/// Position measured from the images of one frame alone, without a prediction. The errors of
/// measurements in different frames are independent. World frame, meters; covariance in m².
struct PositionMeasurement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// Estimate of one target in one frame. World frame, meters, seconds; covariance in m².
struct TrajectorySample {
  double time = 0.0;
  std::int64_t frame = 0;
  std::string target;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// Effective sample size of the particles: 1 / sum of squared weights.
  double effectiveSampleSize = 0.0;
  int cameraCount = 0; ///< number of cameras that show the target
  bool isValid = true; ///< true: the target is tracked, and its position is usable
  /// Measurement in this frame; empty: the target was not seen, or the measurement is not known.
  std::optional<PositionMeasurement> measurement;
  double existenceProbability = 0.0; ///< probability that the target exists; not stored in files
  /// Particle of highest weight (MAP); empty: not known.
  std::optional<Eigen::Vector3d> bestParticle;
  bool isCorrected = false; ///< the user corrected the position in this frame
  bool isAmbiguous = false; ///< another object is about as likely to be the target
  /// Extent (m²) of a target that is not a ball. It describes an ellipsoid whose semi-axes lie
  /// along the eigenvectors and have the square roots of the eigenvalues as lengths. Empty if the
  /// target is a ball or the extent is not known.
  std::optional<Eigen::Matrix3d> extent;
};

/// Position and optical axis of a camera in the world frame. They are used to split an error into
/// its components along and across the axis.
struct TrajectoryCamera {
  std::string name;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d opticalAxis = Eigen::Vector3d::UnitZ();
};

/// Header of a trajectory file.
struct TrajectoryHeader {
  /// Names and values of the header entries: method, seed, parameters, version.
  std::vector<std::pair<std::string, std::string>> entries;
  std::vector<TrajectoryCamera> cameras;
  bool hasMeasurements = false;    ///< the file has columns for `measurement`
  bool hasBestParticles = false;   ///< the file has columns for `bestParticle`
  bool hasCorrectedColumn = false; ///< the file has a column for `isCorrected`
  bool hasAmbiguousColumn = false; ///< the file has a column for `isAmbiguous`
  bool hasExtent = false;          ///< the file has columns for `extent`
};

/// A trajectory: its header, and the samples of all targets.
struct Trajectory {
  TrajectoryHeader header;
  std::vector<TrajectorySample> samples;
};

} // namespace dewpoint::trajectory

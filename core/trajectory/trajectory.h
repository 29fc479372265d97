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

/// A position from the images of one frame alone, without what was known before: a measurement with
/// errors of its own. World frame, meters; covariance in m².
struct PositionMeasurement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// One target at one frame. World frame, meters, seconds; covariance in m².
struct TrajectorySample {
  double time = 0.0;
  std::int64_t frame = 0;
  std::string target;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double effectiveSampleSize = 0.0;
  int cameras = 0;
  bool valid = true;
  std::optional<PositionMeasurement> seen; ///< nothing: not seen in this frame, or not known
  double existenceProbability = 0.0;       ///< probability that the target is there; not in files
  std::optional<Eigen::Vector3d> best;     ///< particle of highest weight (MAP); nothing: not known
  bool corrected = false;                  ///< the user said in this frame where the target is
  bool ambiguous = false;                  ///< something else may be the target about as well
  /// Of what is no ball (m²): an ellipsoid whose semi-axes are the roots of its eigenvalues, along
  /// its eigenvectors; nothing: a ball, or not known.
  std::optional<Eigen::Matrix3d> extent;
};

/// Where a camera stood, so that an error can be split along and across its optical axis.
struct TrajectoryCamera {
  std::string name;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d opticalAxis = Eigen::Vector3d::UnitZ();
};

/// The contents of a trajectory file's header.
struct TrajectoryHeader {
  std::vector<std::pair<std::string, std::string>> entries; ///< method, seed, parameters, version
  std::vector<TrajectoryCamera> cameras;
  bool hasSeen = false;      ///< the file has columns for `seen`
  bool hasBest = false;      ///< the file has columns for `best`
  bool hasCorrected = false; ///< the file has a column for `corrected`
  bool hasAmbiguous = false; ///< the file has a column for `ambiguous`
  bool hasExtent = false;    ///< the file has columns for `extent`
};

struct Trajectory {
  TrajectoryHeader header;
  std::vector<TrajectorySample> samples;
};

} // namespace dewpoint::trajectory

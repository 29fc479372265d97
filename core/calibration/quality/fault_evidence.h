// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Image of a point of a body in one camera.
struct ImagePoint {
  std::size_t instant = 0; ///< index of the state (position of the body at one time)
  std::size_t id = 0;      ///< index of the point on the body
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// Image points of all cameras. The known lengths of what was filmed (squares of the board, length
/// of the wand) are left out. A wrong length therefore has no effect on a search that uses only
/// image points.
struct ImagePoints {
  std::vector<double> times; ///< time of each state, seconds
  std::vector<std::vector<ImagePoint>> pointsPerCamera;
  std::size_t maxPointsPerState = 1; ///< largest number of points per state
};
/// Returns the image points of a bundle problem.
ImagePoints imagePointsOf(const BundleProblem& problem);

/// Standard deviations of the poses in the initial rig.
struct InitialRigSigma {
  double rotation = 0.06; ///< standard deviation of the rotation about each camera axis, radians
  double position = 0.12; ///< standard deviation of the position along each world axis, meters
};

/// Poses of cameras, fitted to the images of points whose positions are unknown.
struct PointFit {
  CameraRig rig;
  /// Robust standard deviation of an image point per axis, corrected for the degrees of freedom;
  /// pixels.
  double sigmaPx = 0.0;
  std::vector<double> squaredResiduals; ///< squared residuals per axis, pixels²
  std::size_t pointCount = 0;
};

/// Estimates the poses of the cameras selected by `use`, from up to 240 points that at least two of
/// these cameras see. If `centersFree`, also estimates their principal points. If any camera ends
/// up far from its initial pose, all residuals are set to a large value, so that the solution does
/// not count as an explanation. Returns nothing if there is no solution.
std::optional<PointFit> estimateStructureAndPoses(const CameraRig& initialRig,
                                                  const ImagePoints& imagePoints,
                                                  const std::vector<bool>& use,
                                                  const InitialRigSigma& sigma,
                                                  bool centersFree = false);

/// Point positions (world, meters) triangulated by some of the cameras, indexed by state, then by
/// ImagePoint::id.
using PointPositions = std::vector<std::vector<std::optional<Eigen::Vector3d>>>;
/// Triangulates the image points with the cameras selected by `use`.
PointPositions triangulatedPositions(const CameraRig& rig, const ImagePoints& imagePoints,
                                     const std::vector<bool>& use);

/// Point with known position, and the pixel at which one camera sees it.
struct PointCorrespondence {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double time = 0.0; ///< time of the state, seconds
};

/// Pose (and focal length) of one camera estimated from points with known positions (resection).
struct CameraResection {
  Camera camera;
  /// Squared residuals per axis, pixels²; set to a large value for points that the camera cannot
  /// see, or for all points if the pose is far from the initial one.
  std::vector<double> squaredResiduals;
};
/// Estimates the pose of one camera near `initial` from points with known positions and, if
/// `isFocalFree`, its focal length. `quick`: uses fewer iterations, for a start value that is
/// already close. Returns nothing if there is no solution.
std::optional<CameraResection> fitCamera(const Camera& initial,
                                         const std::vector<PointCorrespondence>& correspondences,
                                         const InitialRigSigma& sigma, bool isFocalFree,
                                         bool quick = false);

/// Returns the mean negative log likelihood of residuals under Student's t distribution (4 degrees
/// of freedom), up to a constant. This distribution gives outliers little weight.
double meanCost(const std::vector<double>& squares, double sigmaPx);

/// Returns at most `most` elements of a list, evenly spread, in their order.
template <class T> std::vector<T> selectEvenly(const std::vector<T>& all, std::size_t most) {
  if (all.size() <= most) {
    return all;
  }
  std::vector<T> part;
  for (std::size_t i = 0; i < most; ++i) {
    part.push_back(all[i * all.size() / most]);
  }
  return part;
}

} // namespace dewpoint::calibration

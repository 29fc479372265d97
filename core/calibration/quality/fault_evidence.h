// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Image point of a camera, with the index of the point and the instant.
struct ImagePoint {
  std::size_t instant = 0; ///< index of the state
  std::size_t id = 0;      ///< index of the point on the body
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// Image points of all cameras without the bodies. No lengths are assumed.
struct ImagePoints {
  std::vector<double> times; ///< time of each instant, seconds
  std::vector<std::vector<ImagePoint>> perCamera;
  std::size_t ids = 1; ///< largest number of points per instant
};
/// Returns the image points of a bundle problem.
ImagePoints imagePointsOf(const BundleProblem& problem);

/// Standard deviations of the poses in the initial rig.
struct InitialRigSigma {
  double turn = 0.06;     ///< radians
  double position = 0.12; ///< meters
};

/// Rig that explains points with unknown positions.
struct PointFit {
  CameraRig rig;
  double sigmaPx = 0.0; ///< robust standard deviation of an image point per axis, corrected for the
                        ///< degrees of freedom; pixels
  std::vector<double> squares; ///< squared residuals per axis, pixels²
  std::size_t points = 0;
};

/// Estimates the poses of the cameras selected by `use` from up to 240 points that at least two of
/// them see, and if `centersFree`, also their principal points. The solution is near the initial
/// rig: if a camera ends up far from its initial pose, its residuals count as outliers. Returns
/// nothing if there is no solution.
std::optional<PointFit> estimateStructureAndPoses(const CameraRig& initialRig,
                                                  const ImagePoints& imagePoints,
                                                  const std::vector<bool>& use,
                                                  const InitialRigSigma& sigma,
                                                  bool centersFree = false);

/// Point positions (world, meters) triangulated by the cameras selected by `use`, indexed by
/// instant, then id.
using PointPositions = std::vector<std::vector<std::optional<Eigen::Vector3d>>>;
/// Triangulates the image points with the cameras selected by `use`.
PointPositions triangulated(const CameraRig& rig, const ImagePoints& imagePoints,
                            const std::vector<bool>& use);

/// Point with known position, and its pixel in the image of one camera.
struct PointCorrespondence {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double time = 0.0;
};

/// Pose (and focal length) of one camera estimated from points with known positions (resection).
struct CameraResection {
  Camera camera;
  std::vector<double>
      squares; ///< squared residuals per axis, pixels²; large for points outside the camera's view
};
/// Estimates the pose of one camera near `initial` from points with known positions and, if
/// `focalFree`, its focal length.
std::optional<CameraResection> fitCamera(const Camera& initial,
                                         const std::vector<PointCorrespondence>& correspondences,
                                         const InitialRigSigma& sigma, bool focalFree,
                                         bool quick = false);

/// Returns the mean negative log likelihood of residuals under Student's t distribution (4 degrees
/// of freedom), up to a constant. This distribution gives outliers little weight.
double meanCost(const std::vector<double>& squares, double sigmaPx);

/// Selects at most `most` elements, evenly spread.
template <class T> std::vector<T> evenSelection(const std::vector<T>& all, std::size_t most) {
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// One image point of a camera: which point, at which instant.
struct ImagePoint {
  std::size_t instant = 0; ///< number of the state
  std::size_t id = 0;      ///< of the body's points
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// Image points of all cameras, bodies taken apart: nothing is assumed of lengths.
struct ImagePoints {
  std::vector<double> times; ///< of the instants, seconds
  std::vector<std::vector<ImagePoint>> perCamera;
  std::size_t ids = 1; ///< points an instant can have
};
ImagePoints imagePointsOf(const BundleProblem& problem);

/// How far the rig may be off.
struct InitialRigSigma {
  double turn = 0.06;     ///< radians
  double position = 0.12; ///< meters
};

/// A rig that explains points by themselves.
struct PointFit {
  CameraRig rig;
  double sigmaPx = 0.0;        ///< of an image point per axis, robust, for the freedoms left
  std::vector<double> squares; ///< of residuals per axis, pixels²
  std::size_t points = 0;
};

/// The poses of the cameras that `use` names, from up to 240 points that two of them see, near the
/// initial rig (residuals count as gross where a camera ends far from it); with `centersFree` their
/// principal points too. Nothing when they cannot be solved.
std::optional<PointFit> estimateStructureAndPoses(const CameraRig& initialRig,
                                                  const ImagePoints& imagePoints,
                                                  const std::vector<bool>& use,
                                                  const InitialRigSigma& sigma,
                                                  bool centersFree = false);

/// Where the points are, as the cameras that `use` names see them with the rig: by instant, then
/// id.
using PointPositions = std::vector<std::vector<std::optional<Eigen::Vector3d>>>;
PointPositions triangulated(const CameraRig& rig, const ImagePoints& imagePoints,
                            const std::vector<bool>& use);

/// A point of known position in the image of one camera.
struct PointCorrespondence {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double time = 0.0;
};

/// One camera's pose (and focal length) from points of known position (resection).
struct CameraResection {
  Camera camera;
  std::vector<double> squares; ///< of residuals per axis, pixels²; large where it sees nothing
};
std::optional<CameraResection> fitCamera(const Camera& initial,
                                         const std::vector<PointCorrespondence>& correspondences,
                                         const InitialRigSigma& sigma, bool focalFree,
                                         bool quick = false);

/// The mean of minus log-likelihood of residuals under Student's distribution (4 degrees), up to a
/// constant: gross errors count little.
double meanCost(const std::vector<double>& squares, double sigmaPx);

/// At most `most` of the elements, evenly.
template <class T> std::vector<T> spreadOver(const std::vector<T>& all, std::size_t most) {
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

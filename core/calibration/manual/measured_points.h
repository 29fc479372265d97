// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/image_symmetry.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Where one camera sees a measured point.
struct PointClick {
  int camera = 0; ///< of the rig, from 0
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();

  bool operator==(const PointClick&) const = default;
};

/// A point of the room that was measured with a tape and clicked in images.
struct MeasuredPoint {
  std::string name;
  Eigen::Vector3d world = Eigen::Vector3d::Zero(); ///< meters
  std::vector<PointClick> clicks;                  ///< at most one per camera

  bool operator==(const MeasuredPoint&) const = default;
};

/// The click of a point in a camera; null when there is none.
const PointClick* clickIn(const MeasuredPoint& point, int camera);

/// Sets the pixel at which a camera sees the point, in place of an earlier one.
void setClickIn(MeasuredPoint& point, int camera, const Eigen::Vector2d& pixel);

/// How far a click is from where its camera should see the point.
struct ClickResidual {
  int point = 0;
  int camera = 0;
  double pixels = 0.0; ///< infinite where the camera does not see the point
  double meters = 0.0; ///< from the point to the ray of the click
};
std::vector<ClickResidual> clickResiduals(const CameraRig& rig,
                                          const std::vector<MeasuredPoint>& points);

/// Why a camera has no trustworthy pose from its points.
enum class PoseStatus {
  None,
  TooFew,    ///< fewer than four points
  Collinear, ///< the points lie on one line
  Ambiguous, ///< they lie in one plane, and two poses explain them about as well
  NoPose     ///< no pose has them all in front of the camera
};

/// Another way the pictures of a camera must lie to explain its clicks.
struct SymmetryProposal {
  ImageSymmetry symmetry;     ///< to be applied to the pictures as they are now
  double rmsPx = 0.0;         ///< with it
  bool byUprightness = false; ///< it fits no better, but the camera would stand upright
};

struct CameraFromPoints {
  int camera = 0;
  int clicks = 0;
  PoseStatus status = PoseStatus::None;
  double rmsPx = 0.0;
  std::optional<SymmetryProposal> proposal;
};

struct PointSolution {
  CameraRig rig; ///< cameras that were solved have a new pose, the others their former one
  std::vector<CameraFromPoints> cameras; ///< those with a click
  std::vector<ClickResidual> residuals;  ///< with the rig, against the points as typed
  double rmsPx = 0.0;
  std::optional<int> worst;   ///< the point with the largest residual
  bool worstExplains = false; ///< without it the rest fits: it was mistyped or misclicked

  bool anySolved() const;
};

struct PointSettings {
  bool alsoFocal = false; ///< focal lengths too, of cameras with six points or more
  /// Standard deviations that the refinement over all cameras weighs by.
  double tape = 0.003; ///< meters
  double click = 0.5;  ///< pixels
};

/// The poses of all cameras from their clicks on measured points: for each camera perspective-n-
/// point (SQPnP, Terzakis and Lourakis 2020; IPPE, Collins and Bartoli 2014, for points in a plane)
/// and least squares, then poses and points of all cameras together (Ceres), each point held near
/// what the tape said. Cameras whose status is not None keep their pose, but for Ambiguous, where
/// the better of both is taken. When the pictures of a camera fit only rotated or mirrored, that is
/// proposed.
PointSolution solveFromPoints(const CameraRig& rig, const std::vector<MeasuredPoint>& points,
                              const PointSettings& settings = {});

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/image_symmetry.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Pixel at which a camera sees a measured point.
struct PointClick {
  int camera = 0; ///< camera index in the rig
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  /// Number of the recorded frame in whose image the user clicked, from 0; empty if it is unknown.
  std::optional<std::int64_t> frame = std::nullopt;

  bool operator==(const PointClick&) const = default;
};

/// A point in the room whose position was measured with a tape, and which was clicked in images.
struct MeasuredPoint {
  std::string name;
  Eigen::Vector3d world = Eigen::Vector3d::Zero(); ///< measured position, meters
  std::vector<PointClick> clicks;                  ///< clicks on the point, at most one per camera

  bool operator==(const MeasuredPoint&) const = default;
};

/// Returns the click on a point in a camera's image, or null if there is none.
const PointClick* findClick(const MeasuredPoint& point, int camera);

/// Sets the pixel at which a camera sees the point, and the frame of the click (PointClick::frame).
/// Replaces an earlier click in this camera.
void setClickIn(MeasuredPoint& point, int camera, const Eigen::Vector2d& pixel,
                std::optional<std::int64_t> frame = std::nullopt);

/// Returns whether the point was clicked only in frames other than `frame`. If the point moves,
/// like a ball, it is then at another position in the images of this frame. False if the frame of
/// any click is unknown, or if there are no clicks.
bool isClickedOnlyInOtherFrames(const MeasuredPoint& point, std::int64_t frame);

/// Distance between a click and the pixel at which the camera should see the point.
struct ClickResidual {
  int pointIndex = 0;
  int camera = 0;
  /// Distance in the image, pixels; infinite if the camera does not see the point.
  double imageDistancePx = 0.0;
  double rayDistance = 0.0; ///< distance from the point to the ray through the click, meters
};
/// Returns the residuals of all clicks for the current poses of the rig.
std::vector<ClickResidual> clickResiduals(const CameraRig& rig,
                                          const std::vector<MeasuredPoint>& points);

/// Number of clicked points that a camera needs for its pose. Three points allow up to four poses.
inline constexpr int kFewestPointsOfPose = 4;
/// Number of clicked points that a camera needs for its pose and focal length. Four points would
/// barely determine these seven numbers, so one wrong click would spoil the focal length.
inline constexpr int kFewestPointsOfFocal = 6;

/// Reason why a camera has no reliable pose from its points.
enum class PoseStatus {
  None,
  TooFew,    ///< fewer than four points were clicked (kFewestPointsOfPose)
  Collinear, ///< the points lie on one line
  Ambiguous, ///< the points lie in one plane, and two poses explain them about equally well
  NoPose     ///< no pose has all points in front of the camera
};

/// Proposal to rotate or mirror all images of a camera, because its clicks show that the images are
/// rotated or mirrored.
struct SymmetryProposal {
  ImageSymmetry symmetry; ///< rotation or mirroring to apply to the current images
  double rmsPx = 0.0;     ///< reprojection error after `symmetry` is applied, pixels
  /// True if `symmetry` does not make the clicks fit better, but makes the camera upright.
  bool isBasedOnUprightness = false;
};

/// Pose status and fit of one camera whose pose solveFromPoints() estimated from clicks on points.
struct CameraFromPoints {
  int camera = 0;
  int clickCount = 0;
  PoseStatus status = PoseStatus::None;
  double rmsPx = 0.0;
  std::optional<SymmetryProposal> proposal;
};

/// Result of solveFromPoints(): camera poses estimated from clicks on measured points.
struct PointSolution {
  CameraRig rig;                         ///< solved cameras have a new pose; the others keep theirs
  std::vector<CameraFromPoints> cameras; ///< cameras with at least one click
  /// Residuals of all clicks for the solved rig and the points as entered.
  std::vector<ClickResidual> residuals;
  double rmsPx = 0.0;
  /// Index of the wrong point if `isWorstPointWrong`; otherwise, index of the point with the
  /// largest residual.
  std::optional<int> worstPoint;
  /// True if all other points fit when the point `worstPoint` is left out. That point was then
  /// entered or clicked incorrectly.
  bool isWorstPointWrong = false;

  bool hasSolvedCamera() const;
};

/// Settings of solveFromPoints(), which estimates camera poses from clicks on measured points.
struct PointSettings {
  /// True to estimate the focal lengths of cameras with kFewestPointsOfFocal points.
  bool estimatesFocal = false;
  double tapeSigma = 0.003; ///< standard deviation of a tape measurement, meters
  double clickSigma = 0.5;  ///< standard deviation of a click, pixels
};

/// Estimates the poses of all cameras from clicks on measured points.
///
/// Each camera is solved by perspective-n-point (SQPnP, Terzakis and Lourakis 2020; for coplanar
/// points IPPE, Collins and Bartoli 2014) and least squares. Then the poses and points of all
/// cameras are refined together (Ceres), with each point held near its measured position. A camera
/// keeps its pose if its status is not None, with one exception: if the status is Ambiguous, the
/// better of the two poses is used. If the images of a camera fit only after they are rotated or
/// mirrored, the result contains a proposal to do this.
PointSolution solveFromPoints(const CameraRig& rig, const std::vector<MeasuredPoint>& points,
                              const PointSettings& settings = {});

} // namespace dewpoint::calibration

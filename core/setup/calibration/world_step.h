// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/manual/measured_points.h"
#include "core/calibration/world/world_frame.h"
#include "core/filter/gaussian.h"
#include "core/project/project.h"

#include <vector>

namespace dewpoint::setup {

/// Change of the world frame that follows from points clicked in the images.
enum class WorldStep {
  Upright, ///< quarter turns until the images are upright; needs no point
  Floor,   ///< three or more points of the floor; see changeToFloor()
  Level,   ///< two points at the same height
  Origin,  ///< one point
  XAxis,   ///< two points; the x axis points from the first to the second
  Length   ///< two points at a known distance
};

/// Project in a new world frame.
struct WorldStepResult {
  Project project;
  double rotationAngle = 0.0; ///< angle of the rotation of the world frame, radians
  double scale = 1.0;         ///< factor by which all lengths were multiplied
  /// For WorldStep::Floor: root mean square distance of the points from the floor plane, meters.
  double floorRms = 0.0;
};

/// Returns the position of a point that was clicked in the images of at least two cameras (world
/// frame, meters). Only the clicks of the point are used, not its measured position. Returns
/// Undetermined if there is only one click, and otherwise the errors of positionFromClicks(). The
/// field of an error is the name of the point.
Result<Gaussian3> triangulatePoint(const CameraRig& rig, const MeasuredPoint& point);

/// Returns the project after one change of the world frame. `points` are the points of this step,
/// in the order described in WorldStep. `meters` is the measured distance, for Length only.
///
/// Returns BadValue with "points" if the number of points is wrong, and Undetermined with "cameras"
/// if the images are already upright (Upright). Also returns the errors of triangulatePoint() and
/// of the functions in world_frame.h.
Result<WorldStepResult> withWorldStep(const Project& project, WorldStep step,
                                      const std::vector<MeasuredPoint>& points,
                                      double meters = 0.0);

/// Returns the project with the check of a length stored in WorldRecord::lengthCheck: the distance
/// measured in the room, and the distance computed from clicks on its ends. Nothing else changes.
/// Returns the errors of triangulatePoint(), or BadValue, which names "meters".
Result<Project> withLengthCheck(Project project, const MeasuredPoint& from, const MeasuredPoint& to,
                                double meters);

/// Returns whether WorldStep::Upright would change the project, because its images are not upright.
bool canRotateUpright(const Project& project);

} // namespace dewpoint::setup

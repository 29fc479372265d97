// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/world_step.h"

#include "core/geometry/rotation_vector.h"
#include "core/project/project_rig.h"
#include "core/setup/calibration/moved_world.h"
#include "core/setup/clicks/clicked_position.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace dewpoint::setup {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

Result<Positions> positionsOf(const CameraRig& rig, const std::vector<MeasuredPoint>& points) {
  Positions positions;
  for (const MeasuredPoint& point : points) {
    const auto position = triangulatePoint(rig, point);
    if (!position) {
      return tl::make_unexpected(position.error());
    }
    positions.push_back(position->mean);
  }
  return positions;
}

Status checkCount(WorldStep step, std::size_t count) {
  const std::size_t fewest = step == WorldStep::Upright  ? 0
                             : step == WorldStep::Floor  ? 3
                             : step == WorldStep::Origin ? 1
                                                         : 2;
  if (count < fewest || (step != WorldStep::Floor && count > fewest)) {
    return failure(ErrorCode::BadValue, "", "points",
                   step == WorldStep::Floor
                       ? fmt::format("at least {} are needed, not {}", fewest, count)
                       : fmt::format("{} needed, not {}", fewest, count));
  }
  return {};
}

Result<FloorChange> changeOf(WorldStep step, const CameraRig& rig, const Positions& at,
                             double meters) {
  const auto rigid = [](const Similarity& change) { return FloorChange{change, 0.0}; };
  switch (step) {
  case WorldStep::Floor:
    return changeToFloor(at, rig);
  case WorldStep::Level:
    return levelingRotation(at[0], at[1]).map(rigid);
  case WorldStep::Origin:
    return rigid(changeToOrigin(at[0]));
  case WorldStep::XAxis:
    return changeToXAxis(at[0], at[1]).map(rigid);
  case WorldStep::Length:
    return scaleToLength(at[0], at[1], meters).map(rigid);
  case WorldStep::Upright:
    break;
  }
  if (const auto upright = uprightRotation(rig)) {
    return rigid(*upright);
  }
  return failure(ErrorCode::Undetermined, "", "cameras",
                 "their images are upright, or do not show which way is up");
}

void addRecord(WorldStep step, double meters, WorldRecord& record) {
  if (step == WorldStep::Floor || step == WorldStep::Level) {
    record.floorOrigin = CalibrationOrigin::Marks;
  }
  if (step == WorldStep::Length) {
    record.scaleOrigin = CalibrationOrigin::Marks;
    record.scaleError.reset(); // nobody knows how well the person measured
    record.lengthCheck = {meters, meters};
  }
}

} // namespace

Result<Gaussian3> triangulatePoint(const CameraRig& rig, const MeasuredPoint& point) {
  if (point.clicks.size() < 2) {
    return failure(ErrorCode::Undetermined, "", point.name,
                   "click this point in the images of at least two cameras");
  }
  return positionFromClicks(rig, point.clicks, std::nullopt).map_error([&](Error error) {
    error.field = point.name;
    return error;
  });
}

Result<WorldStepResult> withWorldStep(const Project& project, WorldStep step,
                                      const std::vector<MeasuredPoint>& points, double meters) {
  if (const auto counted = checkCount(step, points.size()); !counted) {
    return tl::make_unexpected(counted.error());
  }
  const CameraRig rig = rigOf(project);
  const auto positions = positionsOf(rig, points);
  if (!positions) {
    return tl::make_unexpected(positions.error());
  }
  return changeOf(step, rig, *positions, meters).map([&](const FloorChange& found) {
    Project changed = withMovedWorld(project, found.change);
    addRecord(step, meters, changed.worldRecord);
    return WorldStepResult{std::move(changed), vectorFromRotation(found.change.rotation).norm(),
                           found.change.scale, found.rmsDistance};
  });
}

Result<Project> withLengthCheck(Project project, const MeasuredPoint& from, const MeasuredPoint& to,
                                double meters) {
  if (!(meters > 0.0) || !std::isfinite(meters)) {
    return failure(ErrorCode::BadValue, "", "meters", "a positive distance is expected");
  }
  return positionsOf(rigOf(project), {from, to}).map([&](const Positions& ends) {
    project.worldRecord.lengthCheck = {meters, (ends[1] - ends[0]).norm()};
    return std::move(project);
  });
}

bool canRotateUpright(const Project& project) {
  return uprightRotation(rigOf(project)).has_value();
}

} // namespace dewpoint::setup

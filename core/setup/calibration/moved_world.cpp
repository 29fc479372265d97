// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/moved_world.h"

#include "core/setup/calibration/calibrated_project.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace dewpoint::setup {
namespace {

/// The smallest box parallel to the new axes that contains the old one.
WorldBox moved(const Similarity& change, const WorldBox& box) {
  const Eigen::Vector3d center = change * box.center();
  const Eigen::Vector3d half = change.scale * (change.rotation.cwiseAbs() * box.halfSize());
  return {center - half, center + half};
}

ReferenceGrid moved(const Similarity& change, ReferenceGrid grid) {
  const Eigen::Vector3d along = change.rotation * grid.worldFromGrid().linear().col(0);
  grid.origin = change * grid.origin;
  grid.size *= change.scale;
  grid.step *= change.scale;
  if (along.head<2>().norm() > 0.0) {
    grid.rotationAngle = std::atan2(along.y(), along.x());
  }
  return grid;
}

/// Keys of a box among the parameters of a method. A box on the floor has no half size along z.
struct BoxKeys {
  std::array<const char*, 3> center;
  std::array<const char*, 3> half;
};
constexpr BoxKeys kStart{{"start_x", "start_y", "start_z"},
                         {"start_half_x", "start_half_y", "start_half_z"}};
constexpr BoxKeys kPeopleArea{{"area_x", "area_y", "floor_z"},
                              {"area_half_x", "area_half_y", nullptr}};

const ParameterDeclaration* declarationOf(const ParameterValues& parameters, const char* key) {
  const auto& all = parameters.declarations();
  const auto found = std::ranges::find_if(all, [&](const ParameterDeclaration& declaration) {
    return key != nullptr && declaration.key == key;
  });
  return found == all.end() ? nullptr : &*found;
}

/// A box follows if the person gave any part of it. A value that leaves the range of its
/// declaration is as large as it can be.
void moveBox(const Similarity& change, const BoxKeys& keys, ParameterValues& parameters) {
  WorldBox box;
  bool isGiven = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (declarationOf(parameters, keys.center[axis]) == nullptr) {
      return; // this method has no such box
    }
    const bool hasHalf = keys.half[axis] != nullptr;
    const double center = parameters.at(keys.center[axis]);
    const double half = hasHalf ? parameters.at(keys.half[axis]) : 0.0;
    const auto at = static_cast<Eigen::Index>(axis);
    box.min[at] = center - half;
    box.max[at] = center + half;
    isGiven = isGiven || parameters.isGiven(keys.center[axis]) ||
              (hasHalf && parameters.isGiven(keys.half[axis]));
  }
  if (!isGiven) {
    return;
  }
  box = moved(change, box);
  const auto set = [&](const char* key, double value) {
    if (const ParameterDeclaration* declaration = declarationOf(parameters, key)) {
      (void)parameters.set(key, std::clamp(value, declaration->minimum, declaration->maximum));
    }
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    set(keys.center[axis], box.center()[at]);
    set(keys.half[axis], box.halfSize()[at]);
  }
}

void moveLength(const Similarity& change, std::optional<double>& length) {
  if (length) {
    *length *= change.scale;
  }
}

/// A record stays about the camera if it was: it was not the camera that moved.
void moveCamera(const Similarity& change, ProjectCamera& camera) {
  std::optional<PoseRecord>& record = camera.calibrationRecord.pose;
  const bool wasAbout = record && describes(*record, camera.camera);
  setCalibration(camera, transformed(change, camera.camera));
  if (wasAbout) {
    moveLength(change, record->error);
    record = recordOfPose(camera.camera, record->origin, record->error);
  }
}

} // namespace

Project withMovedWorld(Project project, const Similarity& change) {
  for (ProjectCamera& camera : project.cameras) {
    moveCamera(change, camera);
  }
  moveLength(change, project.worldRecord.errorInsideVolume);
  moveLength(change, project.worldRecord.errorOutsideVolume);
  if (project.grid) {
    project.grid = moved(change, *project.grid);
  }
  for (MeasuredPoint& point : project.measuredPoints) {
    point.world = change * point.world;
  }
  if (project.volumeOfInterest) {
    project.volumeOfInterest = moved(change, *project.volumeOfInterest);
  }
  const Eigen::Matrix3d linear = change.scale * change.rotation;
  for (PositionCorrection& correction : project.corrections) {
    correction.position = change * correction.position;
    const Eigen::Matrix3d covariance = linear * correction.covariance * linear.transpose();
    correction.covariance = 0.5 * (covariance + covariance.transpose());
  }
  for (PersonCorrection& person : project.personCorrections) {
    if (person.position) {
      const Eigen::Vector3d foot(person.position->x(), person.position->y(), 0.0);
      person.position = (change * foot).head<2>();
    }
  }
  moveBox(change, kStart, project.parameters);
  moveBox(change, kPeopleArea, project.parameters);
  return project;
}

} // namespace dewpoint::setup

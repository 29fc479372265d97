// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/watch/camera_repair.h"

#include "core/calibration/manual/moved_camera_pose.h"
#include "core/project/project_format.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace dewpoint::session {
namespace {

/// Of a click in an image of one of two cameras: the other one.
void exchange(int& camera, int a, int b) {
  camera = camera == a ? b : camera == b ? a : camera;
}

void exchangeClicks(Project& project, int a, int b) {
  for (MeasuredPoint& point : project.measuredPoints) {
    for (PointClick& click : point.clicks) {
      exchange(click.camera, a, b);
    }
  }
  for (PositionCorrection& correction : project.corrections) {
    for (PointClick& click : correction.clicks) {
      exchange(click.camera, a, b);
    }
  }
  for (PersonCorrection& person : project.personCorrections) {
    if (person.click) {
      exchange(person.click->camera, a, b);
    }
  }
  for (Target& target : project.targets) {
    for (ColorSample& sample : target.samples) {
      exchange(sample.camera, a, b);
    }
    if (target.box) {
      exchange(target.box->camera, a, b);
    }
  }
}

void exchangeImages(Project& project, std::size_t a, std::size_t b) {
  ProjectCamera& first = project.cameras.at(a);
  ProjectCamera& second = project.cameras.at(b);
  if (first.source == SourceKind::Simulation) {
    std::swap(first.camera, second.camera);
    std::swap(first.camera.name, second.camera.name); // the views keep theirs
    first.markCalibrationChanged();
    second.markCalibrationChanged();
    return;
  }
  std::swap(first, second);
  std::swap(first.camera, second.camera);
  std::swap(first.crop, second.crop); // the calibration is that of the cropped images
  exchangeClicks(project, static_cast<int>(a), static_cast<int>(b));
}

} // namespace

std::size_t repairChoiceCount(const CameraDisagreement& found) {
  switch (found.fault) {
  case CameraFault::Swapped:
    return found.cameras.size() / 2;
  case CameraFault::Late:
  case CameraFault::Unit:
    return 1;
  case CameraFault::Rotated:
    return found.rotationCorrections.size();
  case CameraFault::SamePose:
  case CameraFault::Unknown:
    break;
  }
  return 0;
}

void repairCameras(Project& project, const CameraDisagreement& found, std::size_t choice) {
  assert(choice < repairChoiceCount(found));
  switch (found.fault) {
  case CameraFault::Swapped:
    exchangeImages(project, found.cameras[2 * choice], found.cameras[2 * choice + 1]);
    break;
  case CameraFault::Late: {
    double& delay = project.cameras.at(found.cameras.front()).delay;
    delay = std::clamp(delay + found.delay, -kMaxDelay, kMaxDelay);
    break;
  }
  case CameraFault::Rotated: {
    ProjectCamera& camera = project.cameras.at(found.cameras[choice]);
    camera.camera = rotatedCamera(camera.camera, found.rotationCorrections[choice]);
    camera.markCalibrationChanged();
    break;
  }
  case CameraFault::Unit:
    for (ProjectCamera& camera : project.cameras) {
      camera.camera.cameraFromWorld.translation() *= found.metersPerUnit;
      camera.markCalibrationChanged();
    }
    break;
  case CameraFault::SamePose:
  case CameraFault::Unknown:
    break;
  }
}

} // namespace dewpoint::session

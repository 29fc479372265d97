// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/calibrated_project.h"

#include "core/setup/new_project/new_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace dewpoint::setup {

namespace {

/// Moves what was clicked in the images of a camera, whose new size is given. What has to lie in
/// the image, and does not any more, is removed; other pixels also mean something beside it.
void moveClicks(Project& project, int camera, const Eigen::Vector2d& shift, int width, int height) {
  const auto move = [&](std::vector<PointClick>& clicks) {
    for (PointClick& click : clicks) {
      click.pixel += click.camera == camera ? shift : Eigen::Vector2d::Zero();
    }
  };
  for (MeasuredPoint& point : project.measuredPoints) {
    move(point.clicks);
  }
  for (PositionCorrection& correction : project.corrections) {
    move(correction.clicks);
  }
  for (PersonCorrection& person : project.personCorrections) {
    if (person.click && person.click->camera == camera) {
      person.click->pixel += shift;
    }
  }
  const auto isOutside = [&](double x, double y, double w, double h) {
    return x < 0.0 || y < 0.0 || x + w > width || y + h > height;
  };
  for (Target& target : project.targets) {
    for (ColorSample& sample : target.samples) {
      sample.x += sample.camera == camera ? shift.x() : 0.0;
      sample.y += sample.camera == camera ? shift.y() : 0.0;
    }
    std::erase_if(target.samples, [&](const ColorSample& sample) {
      return sample.camera == camera && isOutside(sample.x, sample.y, sample.width, sample.height);
    });
    if (target.box && target.box->camera == camera) {
      ImageBox& box = target.box->box;
      box.x += shift.x();
      box.y += shift.y();
      if (isOutside(box.x, box.y, box.width, box.height)) {
        target.box.reset();
      }
    }
  }
}

} // namespace

void setCalibration(ProjectCamera& camera, const Camera& calibration) {
  if (camera.camera != calibration) {
    camera.markCalibrationChanged();
  }
  camera.camera = calibration;
}

Project withCameras(Project project, const CameraRig& rig) {
  for (std::size_t c = 0; c < std::min(rig.size(), project.cameras.size()); ++c) {
    setCalibration(project.cameras[c], rig[c]);
  }
  return project;
}

Project withTimeOffsets(Project project, const std::vector<double>& offsets) {
  for (std::size_t c = 0; c < std::min(offsets.size(), project.cameras.size()); ++c) {
    ProjectCamera& camera = project.cameras[c];
    if (camera.source != SourceKind::Simulation) {
      camera.delay -= offsets[c];
    }
  }
  return project;
}

Project withImageSymmetry(Project project, int camera, const ImageSymmetry& symmetry) {
  ProjectCamera& of = project.cameras[static_cast<std::size_t>(camera)];
  const Intrinsics before = of.camera.intrinsics;
  const ImageSymmetry source = combined({of.rotateDegrees, of.isMirrored}, symmetry);
  of.rotateDegrees = source.rotateDegrees;
  of.isMirrored = source.isMirrored;
  of.crop = transformed(symmetry, of.crop);
  of.camera = transformed(symmetry, of.camera);
  for (MeasuredPoint& point : project.measuredPoints) {
    if (const PointClick* click = findClick(point, camera)) {
      setClickIn(point, camera, transformed(symmetry, click->pixel, before.width, before.height),
                 click->frame);
    }
  }
  return project;
}

Project withImageOrientation(Project project, std::size_t camera, int rotateDegrees,
                             bool mirrored) {
  const ProjectCamera& before = project.cameras[camera];
  const ImageSymmetry present{before.rotateDegrees, before.isMirrored};
  const ImageSymmetry wanted{rotateDegrees, mirrored};
  const auto change = std::ranges::find_if(imageSymmetries(), [&](const ImageSymmetry& symmetry) {
    return combined(present, symmetry) == wanted;
  });
  if (change == imageSymmetries().end()) {
    return project; // no rotation by quarters
  }
  const bool isGuess = hasGuessedLens(project, camera) && hasGuessedPose(project, camera);
  project = withImageSymmetry(std::move(project), static_cast<int>(camera), *change);
  if (isGuess) {
    const Intrinsics lens = project.cameras[camera].camera.intrinsics;
    guessCalibration(project, camera, {lens.width, lens.height});
  }
  return project;
}

Result<Project> withImageCrop(Project project, std::size_t camera, const ImageMargins& crop) {
  const ProjectCamera& before = project.cameras.at(camera);
  const std::string& name = before.camera.name;
  if (before.source == SourceKind::Simulation) {
    return failure(ErrorCode::BadValue, "", name,
                   "the images of a simulated camera have no margins");
  }
  if (std::min({crop.left, crop.top, crop.right, crop.bottom}) < 0) {
    return failure(ErrorCode::BadValue, "", name, "the margins to crop must not be negative");
  }
  const Camera cropped = recropped(before.camera, before.crop, crop);
  const int width = cropped.intrinsics.width;
  const int height = cropped.intrinsics.height;
  if (std::min(width, height) < kSmallestCrop) {
    return failure(ErrorCode::Mismatch, "", name,
                   fmt::format("at least {} x {} pixels of the images must be left", kSmallestCrop,
                               kSmallestCrop));
  }
  const bool isGuess = hasGuessedLens(project, camera) && hasGuessedPose(project, camera);
  moveClicks(project, static_cast<int>(camera),
             {before.crop.left - crop.left, before.crop.top - crop.top}, width, height);
  ProjectCamera& changed = project.cameras[camera];
  if (changed.calibrationRecord.lens) { // it is still the same lens
    changed.calibrationRecord.lens->describedIntrinsics[2] += before.crop.left - crop.left;
    changed.calibrationRecord.lens->describedIntrinsics[3] += before.crop.top - crop.top;
  }
  changed.camera = cropped;
  changed.crop = crop;
  if (isGuess) {
    guessCalibration(project, camera, {width, height});
  }
  return project;
}

bool canSetImageSymmetry(const ProjectCamera& camera) {
  return camera.source != SourceKind::Simulation;
}

Project withProposedSymmetries(Project project, const std::vector<CameraFromPoints>& cameras) {
  for (const CameraFromPoints& found : cameras) {
    if (found.proposal &&
        canSetImageSymmetry(project.cameras.at(static_cast<std::size_t>(found.camera)))) {
      project = withImageSymmetry(std::move(project), found.camera, found.proposal->symmetry);
    }
  }
  return project;
}

Project withPointSolution(Project project, const PointSolution& solution, bool focal) {
  project = withCameras(std::move(project), solution.rig);
  for (const CameraFromPoints& found : solution.cameras) {
    if (found.status == PoseStatus::None) {
      ProjectCamera& camera = project.cameras.at(static_cast<std::size_t>(found.camera));
      camera.calibrationRecord.pose = recordOfPose(camera.camera, CalibrationOrigin::Points);
      if (focal && found.clickCount >= kFewestPointsOfFocal) { // else it was kept
        camera.calibrationRecord.lens = recordOfLens(camera.camera, CalibrationOrigin::Points);
      }
    }
  }
  if (solution.hasSolvedCamera()) {
    // The positions of the points are in the world frame, and in meters.
    project.worldRecord = {};
    project.worldRecord.scaleOrigin = CalibrationOrigin::Points;
    project.worldRecord.floorOrigin = CalibrationOrigin::Points;
  }
  return project;
}

Project withIntrinsics(Project project,
                       const std::vector<std::optional<IntrinsicsResult>>& results) {
  for (std::size_t k = 0; k < std::min(results.size(), project.cameras.size()); ++k) {
    if (!results[k]) {
      continue;
    }
    Camera camera = project.cameras[k].camera;
    camera.intrinsics = results[k]->camera.intrinsics;
    camera.distortion = results[k]->camera.distortion;
    camera.lens = results[k]->camera.lens;
    setCalibration(project.cameras[k], camera);
  }
  return project;
}

} // namespace dewpoint::setup

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/method_checks.h"

#include "core/geometry/projector.h"
#include "core/project/project_rig.h"
#include "core/setup/method_obstacle.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/trajectory/trajectory_reader.h"

#include <algorithm>
#include <string>

namespace dewpoint::setup {
namespace {

/// Points along each side of a volume that are tried.
constexpr int kVolumeSteps = 12;

void checkObstacle(Examination& examination) {
  const Project& project = examination.project;
  const Method* method = findMethod(project.method);
  if (method == nullptr) {
    return; // such a project cannot be read
  }
  switch (methodObstacle(project, *method)) {
  case MethodObstacle::None:
    examination.add(FindingKind::MethodFits, {project.method});
    break;
  case MethodObstacle::NoCalibration:
    examination.add(FindingKind::NeedsCalibration, {project.method}, "method");
    break;
  case MethodObstacle::TooFewCameras:
    examination.add(FindingKind::NeedsMoreCameras,
                    {project.method, std::to_string(method->family.minCameraCount),
                     std::to_string(project.cameras.size())},
                    "method");
    break;
  }
}

std::size_t countSeeing(const std::vector<Projector>& cameras, const Eigen::Vector3d& point) {
  return static_cast<std::size_t>(std::ranges::count_if(cameras, [&](const Projector& camera) {
    const auto pixel = camera.project(point);
    return pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 &&
           pixel->x() < camera.intrinsics().width && pixel->y() < camera.intrinsics().height;
  }));
}

bool isSeen(const WorldBox& volume, const std::vector<Projector>& cameras, std::size_t needed) {
  for (int i = 0; i <= kVolumeSteps; ++i) {
    for (int j = 0; j <= kVolumeSteps; ++j) {
      for (int k = 0; k <= kVolumeSteps; ++k) {
        const Eigen::Vector3d part = Eigen::Vector3d(i, j, k) / kVolumeSteps;
        if (countSeeing(cameras, volume.min + part.cwiseProduct(volume.max - volume.min)) >=
            needed) {
          return true;
        }
      }
    }
  }
  return false;
}

void checkVolume(Examination& examination) {
  const Project& project = examination.project;
  if (!project.volumeOfInterest || !methodFamily(project.method).needsCalibration) {
    return;
  }
  std::vector<Projector> cameras;
  for (const Camera& camera : rigOf(project)) {
    cameras.emplace_back(camera);
  }
  const std::size_t needed = std::min<std::size_t>(2, cameras.size());
  if (!isSeen(*project.volumeOfInterest, cameras, needed)) {
    examination.add(FindingKind::VolumeOutOfView, {std::to_string(needed)}, "volume_of_interest");
  }
}

void checkCorrectionFrames(Examination& examination) {
  std::int64_t end = 0;
  for (const CameraFootage& footage : examination.footage) {
    end = std::max(end, footage.frameCount);
  }
  const auto isLate = [end](const auto& one) { return one.frame >= end; };
  const auto late = std::ranges::count_if(examination.project.corrections, isLate) +
                    std::ranges::count_if(examination.project.personCorrections, isLate);
  if (end > 0 && late > 0) {
    examination.add(FindingKind::CorrectionTooLate, {std::to_string(late)}, "correction.frame");
  }
}

void checkTruth(Examination& examination) {
  if (const auto& truth = examination.project.truthFile) {
    if (const auto read = readTrajectory(*truth); !read) {
      examination.addForFile(truth->string(), FindingKind::TruthUnusable,
                             {messageWithoutFile(read.error())});
    }
  }
}

} // namespace

void checkMethod(Examination& examination) {
  checkObstacle(examination);
  checkVolume(examination);
  checkCorrectionFrames(examination);
  checkTruth(examination);
}

} // namespace dewpoint::setup

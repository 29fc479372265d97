// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/method_obstacle.h"

#include "core/project/project.h"
#include "core/setup/new_project/new_project.h"
#include "core/tracking/catalog/method_catalog.h"

#include <algorithm>

namespace dewpoint::setup {
namespace {

/// Some camera came without a calibration, and nothing was guessed in its place.
bool isBare(const Project& project) {
  return std::ranges::any_of(project.cameras, [](const ProjectCamera& camera) {
    return camera.camera.intrinsics.width == 0;
  });
}

} // namespace

MethodObstacle methodObstacle(const Project& project, const Method& method) {
  const MethodFamily& family = method.family;
  const std::size_t count = project.cameras.size();
  if (count > 0 && count < static_cast<std::size_t>(family.minCameraCount)) {
    return MethodObstacle::TooFewCameras;
  }
  const bool goesByGuess = !family.findsTargets() && count > 1;
  const bool isUnknown = isBare(project) || (!goesByGuess && hasGuessedPose(project));
  return family.needsCalibration && isUnknown ? MethodObstacle::NoCalibration
                                              : MethodObstacle::None;
}

} // namespace dewpoint::setup

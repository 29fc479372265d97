// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/agreement_checks.h"

#include "core/base/time.h"
#include "core/camera_motion/agreement/camera_agreement.h"
#include "core/camera_motion/agreement/disagreement_sentence.h"
#include "core/project/project_rig.h"
#include "core/tracking/catalog/method_catalog.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::setup {
namespace {

/// Seconds of a recording that are watched: swapped and late cameras are named within a few seconds
/// of motion, and decoding them takes about as long.
constexpr double kCheckedSeconds = 10.0;

bool matchesScene(const ProjectCamera& camera) {
  return camera.source == SourceKind::Simulation && !camera.hasOwnCalibration;
}

} // namespace

void checkAgreement(Examination& examination) {
  const Project& project = examination.project;
  if (!examination.options.open || examination.hasProblem() ||
      std::ranges::any_of(project.cameras, &ProjectCamera::isLive)) {
    return; // it could not be opened, or should not be
  }
  auto source = examination.options.open(project);
  if (!source) {
    examination.add(FindingKind::CannotOpen, {errorSentence(source.error())});
    return;
  }
  const MethodFamily family = methodFamily(project.method);
  if (project.cameras.size() < 2 || !family.needsCalibration || !family.hasColorMasks() ||
      std::ranges::all_of(project.cameras, matchesScene)) {
    return; // it was only to be opened
  }
  const CameraRig rig = rigOf(project);
  camera_motion::CameraAgreement agreement(rig);
  while (agreement.disagreements().empty()) {
    const auto set = (*source)->next();
    if (!set) {
      examination.add(FindingKind::CannotOpen, {errorSentence(set.error())});
      return;
    }
    if (!*set || seconds((*set)->time) > kCheckedSeconds ||
        !examination.options.shouldContinue(seconds((*set)->time) / kCheckedSeconds)) {
      break;
    }
    agreement.watch(**set, project.targets);
  }
  for (const camera_motion::CameraDisagreement& found : agreement.disagreements()) {
    examination.add(FindingKind::CamerasDisagree,
                    {fmt::format("{:g}", kCheckedSeconds), describeDisagreement(found, rig)},
                    "camera");
  }
}

} // namespace dewpoint::setup

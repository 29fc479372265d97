// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/watch/camera_agreement_watch.h"

#include "core/tracking/catalog/method_catalog.h"

#include <algorithm>

namespace dewpoint::session {

Status CameraAgreementWatch::onFrameTracked(const TrackingRun& run) {
  const MethodFamily family = run.definition()->family();
  if (family.needsCalibration && family.hasColorMasks() && !paused_) {
    agreement_.watch(*run.frames(), run.targets());
  }
  return {};
}

std::vector<CameraDisagreement>
CameraAgreementWatch::disagreements(const MethodFamily& family) const {
  if (!family.needsCalibration) {
    return {};
  }
  std::vector<CameraDisagreement> found = agreement_.disagreements();
  std::erase_if(found, [this](const CameraDisagreement& one) {
    const bool mayBeMotion = one.fault == CameraFault::Rotated || one.fault == CameraFault::Unknown;
    return mayBeMotion && std::ranges::any_of(motion_.reports(), [&](const auto& report) {
             return !report.isBackInPose &&
                    std::ranges::find(one.cameras, report.event.camera) != one.cameras.end();
           });
  });
  return found;
}

} // namespace dewpoint::session

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/calibration_checks.h"

#include "core/calibration/formats/calibration_plausibility.h"
#include "core/camera_motion/agreement/rig_check.h"
#include "core/geometry/seen_volume.h"
#include "core/project/project_rig.h"
#include "core/setup/new_project/new_project.h"
#include "core/tracking/catalog/method_catalog.h"

#include <fmt/format.h>

namespace dewpoint::setup {
namespace {

/// Meters under the floor up to which a camera may be said to be on it.
constexpr double kOnTheFloor = 0.05;

/// Faults of the rig by itself; whether there is one.
bool checkRigAlone(Examination& examination, const CameraRig& rig) {
  const auto faults = camera_motion::checkRig(rig);
  for (const camera_motion::CameraDisagreement& fault : faults) {
    if (fault.fault == camera_motion::CameraFault::Unit) {
      examination.add(FindingKind::UnitWrong,
                      {fmt::format("{:.0f}", calibration::cameraSpread(rig)),
                       fmt::format("{:g}", fault.metersPerUnit)},
                      "camera.calibration.translation");
    } else {
      examination.add(
          FindingKind::SamePose,
          {examination.nameOf(fault.cameras.at(0)), examination.nameOf(fault.cameras.at(1))},
          cameraKey(fault.cameras.at(1), "calibration"));
    }
  }
  if (!faults.empty()) {
    return true;
  }
  calibration::ParsedCalibration read;
  read.rig = rig;
  for (std::size_t k = 0; k < rig.size(); ++k) { // a principal point may lie in what was cropped
    read.rig[k] = recropped(rig[k], examination.project.cameras[k].crop, {});
  }
  if (const auto plausible = calibration::checkPlausibility(read, {}, ""); !plausible) {
    examination.add(FindingKind::CalibrationImplausible, {plausible.error().detail},
                    "camera.calibration");
    return true;
  }
  return false;
}

void checkFloor(Examination& examination, const CameraRig& rig) {
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const double height = rig[k].center().z();
    if (height < -kOnTheFloor) {
      examination.add(FindingKind::BelowFloor,
                      {examination.nameOf(k), fmt::format("{:.2f}", -height)},
                      cameraKey(k, "calibration.translation"));
    }
  }
}

void checkViews(Examination& examination, const CameraRig& rig) {
  for (std::size_t k = 0; k < rig.size() && rig.size() > 1; ++k) {
    bool shares = false;
    for (std::size_t other = 0; other < rig.size() && !shares; ++other) {
      shares = other != k && commonVolume({rig[k], rig[other]}, 2).has_value();
    }
    if (!shares) {
      examination.add(FindingKind::FacesAway, {examination.nameOf(k)}, cameraKey(k, "calibration"));
    }
  }
}

} // namespace

void checkCalibration(Examination& examination) {
  const Project& project = examination.project;
  const CameraRig rig = rigOf(project);
  if (!methodFamily(project.method).needsCalibration || rig.empty()) {
    return; // the method takes images as they are
  }
  if (hasGuessedPose(project)) {
    examination.add(FindingKind::CalibrationGuessed, {}, "camera.calibration");
    return;
  }
  if (checkRigAlone(examination, rig)) {
    return; // the rest would follow from it
  }
  const std::size_t before = examination.findings.size();
  checkFloor(examination, rig);
  checkViews(examination, rig);
  if (examination.findings.size() == before) {
    examination.add(FindingKind::CalibrationFine,
                    {std::to_string(rig.size()),
                     fmt::format("{:.2f}", rig.size() > 1 ? calibration::cameraSpread(rig) : 0.0)});
  }
}

} // namespace dewpoint::setup

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/workbench/workbench.h"

#include <cstddef>

namespace dewpoint::ui {

class CameraAgreementAlerts;
class ManualCalibration;

/// What a run has to say while it goes: its notices, cameras that were moved and cameras that
/// cannot agree, with what one click does about those.
class RunAlerts : public QObject {
  Q_OBJECT
public:
  RunAlerts(const Workbench& bench, ManualCalibration& hand);

private:
  void showNotices(const TrackSnapshotPtr& snapshot);
  void applyFirstNewPose();
  /// Takes the pose that the run found for a camera that was moved into the project.
  void applyNewPose(int camera);
  void calibrate(int camera);
  void connectAgreement();
  /// Changes the project so that its cameras agree, as a step.
  void mend(const CameraDisagreement& found, std::size_t choice);

  Workbench bench_;
  ManualCalibration& hand_;
  std::size_t noticesShown_ = 0;
};

} // namespace dewpoint::ui

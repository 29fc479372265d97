// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/workbench/workbench.h"

#include <cstddef>

namespace dewpoint::ui {

class CameraAgreementAlerts;
class ManualCalibration;

/// Shows the alerts of a run: its notices, cameras that moved, and cameras that disagree. Performs
/// the corrections that the alerts offer.
class RunAlerts : public QObject {
  Q_OBJECT
public:
  RunAlerts(const Workbench& bench, ManualCalibration& manual);

private:
  void showNotices(const TrackSnapshotPtr& snapshot);
  void applyFirstNewPose();
  /// Applies the pose found by the run for a moved camera to the project.
  void applyNewPose(int camera);
  void calibrate(int camera);
  void connectAgreement();
  /// Changes the project in one step so that its cameras agree. `choice` is the index of the
  /// correction that the user selected.
  void correctRig(const CameraDisagreement& found, std::size_t choice);

  Workbench bench_;
  ManualCalibration& manual_;
  std::size_t noticesShown_ = 0;
};

} // namespace dewpoint::ui

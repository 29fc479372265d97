// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/workbench/workbench.h"

#include <cstddef>

namespace dewpoint::ui {

class CalibrationMode;
class ManualCalibration;
class NoticeList;

/// Shows the alerts of a run: its notices, as long as their causes last, cameras that moved, and
/// cameras that disagree. Performs the corrections that the alerts offer.
class RunAlerts : public QObject {
  Q_OBJECT
public:
  RunAlerts(const Workbench& bench, NoticeList& notices, CalibrationMode& calibration);

private:
  void showNotices(const TrackSnapshotPtr& snapshot);
  /// Adds a button to the status bar that shows hidden notices again.
  void addHiddenButton();
  void applyFirstNewPose();
  /// Stores the new pose that the run has found for a moved camera in the project.
  void applyNewPose(int camera);
  void calibrate(int camera);
  /// Makes the alerts about cameras that disagree disappear while a calibration page is shown.
  void connectAgreement(const CalibrationMode& calibration);
  /// Changes the project in one step so that its cameras agree. `choice` is the index of the
  /// correction that the user selected.
  void correctRig(const CameraDisagreement& found, std::size_t choice);

  Workbench bench_;
  NoticeList& notices_;
  ManualCalibration& manual_;
};

} // namespace dewpoint::ui

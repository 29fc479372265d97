// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

class BirdsEyeView;
class CalibrationMode;
class ManualCalibration;
class RigPlanner;

/// Adds the rig planner to the window: its page and its actions. In the bird's-eye view, adds the
/// map, the planned cameras, and handles for dragging all cameras.
class PlannerInstaller : public QObject {
  Q_OBJECT
public:
  PlannerInstaller(const Workbench& bench, CalibrationMode& mode, BirdsEyeView& birdsEye);

private:
  void connectActions();
  void connectBirdsEye();
  void showHandles();
  void open();
  /// Returns the index of the planned camera for a handle, or a negative number if the camera
  /// belongs to the project.
  int plannedIndex(int handle) const;

  Workbench bench_;
  CalibrationMode& mode_;
  BirdsEyeView& birdsEye_;
  ManualCalibration& manual_;
  RigPlanner* plan_;
};

} // namespace dewpoint::ui

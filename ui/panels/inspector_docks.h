// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class CameraPanel;
class TargetPanel;
class ViewDock;
struct Workbench;

/// Adds the panel for the method and its parameters to the window, and the messages shown when
/// another method is selected.
void installParameters(const Workbench& bench);

/// Dock with the list of targets.
struct TargetDock {
  ViewDock* dock;
  TargetPanel* panel;
};
/// Adds the dock with the list of targets to the window.
TargetDock installTargets(const Workbench& bench);

/// Adds the dock with the list of cameras to the window.
CameraPanel* installCameras(const Workbench& bench);

} // namespace dewpoint::ui

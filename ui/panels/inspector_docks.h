// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class CameraPanel;
class TargetPanel;
class ViewDock;
struct Workbench;

/// Adds the panel for the method and its parameters, and the messages shown when another method is
/// selected.
void installParameters(const Workbench& bench);

/// Dock with the list of targets.
struct TargetDock {
  ViewDock* dock;
  TargetPanel* panel;
};
/// Adds the list of targets.
TargetDock installTargets(const Workbench& bench);

/// Adds the list of cameras.
CameraPanel* installCameras(const Workbench& bench);

} // namespace dewpoint::ui

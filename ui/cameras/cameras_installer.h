// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Adds the dialog *Cameras* (actionCameras), the action *Lock colors* (actionLockColors), and the
/// questions about missing devices to the window.
void installCameraSources(const Workbench& bench);

} // namespace dewpoint::ui

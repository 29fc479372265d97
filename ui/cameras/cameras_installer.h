// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Installs the dialog *Cameras* (actionCameras), *Lock colors* (actionLockColors), and the
/// questions about devices that are missing.
void installCameraSources(const Workbench& bench);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class CameraEdits;
class ColorLocker;
class ControlSync;
class DeviceWatch;

/// Objects that the dialog *Cameras* uses. They exist as long as the window.
struct CameraParts {
  DeviceWatch& watch;
  CameraEdits& edits;
  ColorLocker& locker;
  ControlSync& controls;
};

} // namespace dewpoint::ui

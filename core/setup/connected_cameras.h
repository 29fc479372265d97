// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the window needs of the camera devices of this computer: which are connected, their
// settings and controls, and which one is that of a camera of the project.
#include "core/capture/device_settings.h"
#include "core/capture/devices/camera_device.h"
#include "core/capture/devices/color_lock.h"
#include "core/capture/devices/device_access.h"
#include "core/capture/devices/device_control.h"
#include "core/capture/devices/device_match.h"
#include "core/capture/devices/device_monitor.h"
#include "core/capture/devices/usb_bandwidth.h"

namespace dewpoint::setup {} // namespace dewpoint::setup

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Collects the headers that the window needs for the camera devices of this computer: the connected
// devices, their settings and controls, and the assignment of devices to the cameras of a project.
#include "core/capture/device_settings.h"
#include "core/capture/devices/camera_device.h"
#include "core/capture/devices/color_lock.h"
#include "core/capture/devices/device_access.h"
#include "core/capture/devices/device_control.h"
#include "core/capture/devices/device_match.h"
#include "core/capture/devices/device_monitor.h"
#include "core/capture/devices/usb_bandwidth.h"

namespace dewpoint::setup {} // namespace dewpoint::setup

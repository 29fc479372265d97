// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/camera_device.h"
#include "core/capture/devices/color_lock.h"
#include "core/capture/devices/device_control.h"
#include "core/capture/devices/device_match.h"
#include "core/capture/devices/usb_bandwidth.h"
#include "core/project/project.h"
#include "core/setup/new_project/project_cameras.h"

#include <span>
#include <string>
#include <vector>

namespace dewpoint::setup {

// The cameras of a project and the devices that are connected to this computer. Nothing is opened.

/// Returns the source for a camera that uses a device: its address and its identity.
CameraSource sourceOf(const capture::CameraDevice& device);

/// Returns which device belongs to each camera of a project, in its order. A camera whose device
/// has an identity in the project is recognized by it (capture::matchDevices()). Others, which were
/// written by hand, have the device at their location: a number, a device node, or an address.
/// Cameras that are not devices have none, and are not missing: their basis is None without
/// candidates.
std::vector<capture::DeviceMatch>
matchProjectDevices(const Project& project, std::span<const capture::CameraDevice> devices);

/// Returns the USB buses that cannot carry the images of the project's cameras
/// (capture::bandwidthShortages()), in the formats in which the devices would be opened: where the
/// project requests no size, a calibrated camera has the size of its calibration. `requests` and
/// BandwidthProposal::request are indices of cameras of the project. Cameras whose devices do not
/// offer what is requested are left out: they cannot be opened.
std::vector<capture::BandwidthShortage>
projectBandwidthShortages(const Project& project, std::span<const capture::CameraDevice> devices);

/// Returns what changes the colors of a device by itself at present: its automatic exposure, gain,
/// white balance and hue, if they are on (see capture::lockColors()).
std::vector<capture::ColorAutomatic>
automaticsOn(const std::vector<capture::DeviceControl>& controls);

} // namespace dewpoint::setup

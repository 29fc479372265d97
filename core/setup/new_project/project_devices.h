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

// Functions that relate the cameras of a project to the devices connected to this computer. They
// open no device.

/// Returns the camera source for a device, with the address and the identity of the device.
CameraSource sourceOf(const capture::CameraDevice& device);

/// Returns the device that belongs to each camera of a project, in project order. If the project
/// contains the identity of a camera's device, the device is found by this identity
/// (capture::matchDevices()). Otherwise, it is the device at the camera's location: a number, a
/// device node, or an address. The match is empty for a camera whose source is not a device.
std::vector<capture::DeviceMatch>
matchProjectDevices(const Project& project, std::span<const capture::CameraDevice> devices);

/// Returns the USB buses that are too slow for the images of a project's cameras
/// (capture::findBandwidthShortages()). The formats are those in which the devices would be opened:
/// if the project requests no size, the images of a calibrated camera have the size of its
/// calibration. In the result, BandwidthShortage::requestIndices and
/// BandwidthProposal::requestIndex are indices of cameras in the project. Ignores cameras whose
/// devices do not offer the requested format, because they cannot be opened.
std::vector<capture::BandwidthShortage>
projectBandwidthShortages(const Project& project, std::span<const capture::CameraDevice> devices);

/// Returns which automatic adjustments of a device's colors are currently on: exposure, gain, white
/// balance and hue (see capture::lockColors()).
std::vector<capture::ColorAutomatic>
automaticsOn(const std::vector<capture::DeviceControl>& controls);

} // namespace dewpoint::setup

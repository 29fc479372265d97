// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <vector>

namespace dewpoint::ui {

/// Returns the name of a device, or its path if it has none.
QString deviceName(const capture::CameraDevice& device);
/// Returns the connection and the serial number of a device, for example "USB 3-1.2 · serial number
/// A1B2".
QString devicePortText(const capture::CameraDevice& device);
/// Returns the largest image size and the highest frame rate of each format that a device offers,
/// in one line.
QString formatSummaryText(const capture::CameraDevice& device);
/// Returns all image sizes and frame rates that a device offers, one line for each format.
QString formatDetailsText(const capture::CameraDevice& device);
/// Returns the size and the frame rate of images, for example "640 × 480, 30 per second". Leaves
/// out the rate if it is 0.
QString imageFormatText(const QSize& size, double framesPerSecond);
/// Returns an image size for a list, for example "1280 × 720".
QString imageSizeText(int width, int height);
/// Returns the translated name of a device control, or the driver's name if the control is not a
/// common one.
QString controlText(const capture::DeviceControl& control);
/// Returns the translated name of a menu item of a device control, or the driver's name if the item
/// is not a common one.
QString menuItemText(const capture::DeviceControl& control, const capture::ControlMenuItem& item);
/// Returns the names of automatic functions that change colors, separated by commas, for example
/// "exposure, white balance".
QString colorAutomaticsText(const std::vector<capture::ColorAutomatic>& automatics);
/// Returns a sentence about a bus whose bandwidth is too small for its cameras. `names` are the
/// names of the project's cameras.
QString bandwidthShortageText(const capture::BandwidthShortage& shortage, const QStringList& names);
/// Returns the formats that `shortage` proposes so that the bandwidth suffices, for example "left:
/// MJPG 1280x720 30". `names` are the names of the project's cameras.
QString bandwidthProposalText(const capture::BandwidthShortage& shortage, const QStringList& names);

} // namespace dewpoint::ui

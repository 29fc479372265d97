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
/// Returns where a device is plugged in and its serial number: "USB 3-1.2 · serial number A1B2".
QString devicePlace(const capture::CameraDevice& device);
/// Returns the largest size and the highest rate of each format, in one line.
QString formatSummary(const capture::CameraDevice& device);
/// Returns all sizes and rates, one line for each format.
QString formatDetails(const capture::CameraDevice& device);
/// Returns the size and the rate of images: "640 × 480, 30 per second"; without a rate if it is 0.
QString imageText(const QSize& size, double framesPerSecond);
/// Returns the size of a format in words for a list: "1280 × 720".
QString imageSizeText(int width, int height);
/// Returns a control in words; the driver's words if it is not a common one.
QString controlText(const capture::DeviceControl& control);
/// Returns a menu item of a control; the driver's words if it is not a common one.
QString menuItemText(const capture::DeviceControl& control, const capture::ControlMenuItem& item);
/// Returns the names of automatics, separated by commas: "exposure, white balance".
QString automaticsText(const std::vector<capture::ColorAutomatic>& automatics);
/// Returns a sentence about a bus that cannot carry its cameras. `names`: of the project's cameras.
QString shortageText(const capture::BandwidthShortage& shortage, const QStringList& names);
/// Returns a proposal of `shortage` in words: "left: MJPG 1280x720 30".
QString proposalText(const capture::BandwidthShortage& shortage, const QStringList& names);

} // namespace dewpoint::ui

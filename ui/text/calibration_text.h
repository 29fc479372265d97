// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

namespace dewpoint::calibration {
struct CalibrationAccuracy;
struct DetectedFault;
} // namespace dewpoint::calibration

namespace dewpoint::ui {

/// Returns a translated text about the accuracy of a calibration, for example "In this volume ±3.1
/// mm (95 %), scale ±0.10 %, up ±0.20°."
QString accuracyText(const CalibrationAccuracy& accuracy);

/// Returns a translated text about a fault of a calibration: its likely cause, and how to correct
/// it.
QString faultText(const DetectedFault& fault, const QStringList& cameraNames);

} // namespace dewpoint::ui

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

/// Returns the translated text "In this volume ±3.1 mm (95 %), scale ±0.10 %, up ±0.20°.".
QString accuracyText(const CalibrationAccuracy& accuracy);

/// Returns the likely cause of a fault and its remedy, translated.
QString faultText(const DetectedFault& fault, const QStringList& cameraNames);

} // namespace dewpoint::ui

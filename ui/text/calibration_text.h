// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

namespace dewpoint::calibration {
struct CalibrationAccuracy;
struct NamedFault;
} // namespace dewpoint::calibration

namespace dewpoint::ui {

/// "In this volume ±3.1 mm (95 %), scale ±0.10 %, up ±0.20°." in the language of the window.
QString accuracyText(const CalibrationAccuracy& accuracy);

/// Likely cause of a fault and what to do, in the language of the window.
QString faultText(const NamedFault& fault, const QStringList& cameraNames);

} // namespace dewpoint::ui

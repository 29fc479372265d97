// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {

/// File filter for dialogs that open calibrations: first the suffixes of all supported formats,
/// then one row per format, then all files.
QString calibrationFileFilter();

/// Names of the formats: "OpenCV, Anipose, …".
QString calibrationFormatTitles();

/// Whether a file name has the suffix of a calibration. Such a file is treated as one when it is
/// dropped.
bool endsAsCalibration(const QString& file);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QVariant>

#include <utility>
#include <vector>

namespace dewpoint::ui {

/// Returns the file filter for dialogs that open calibrations: first the suffixes of all supported
/// formats, then one row per format, then all files.
QString calibrationFileFilter();

/// Returns the names of all calibration formats as a list: "OpenCV, Anipose, …".
QString calibrationFormatTitles();

/// Returns whether a file name has a calibration suffix. When such a file is dropped, it is treated
/// as a calibration.
bool hasCalibrationSuffix(const QString& file);

/// Returns the choices for how images can differ from those of a calibration, each a text with the
/// value of the command-line option --fit. The value of the first choice, for images that do not
/// differ, is empty.
std::vector<std::pair<QString, QVariant>> sizeFitChoices();

} // namespace dewpoint::ui

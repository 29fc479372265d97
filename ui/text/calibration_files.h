// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {

/// The filter of dialogs for calibrations of all tools that are known: all their endings first, one
/// row for each format, then all files.
QString calibrationFileFilter();

/// The formats by their usual names: "OpenCV, Anipose, …".
QString calibrationFormatTitles();

/// Whether a file ends as calibrations do, and so is taken for one when it is dropped.
bool endsAsCalibration(const QString& file);

} // namespace dewpoint::ui

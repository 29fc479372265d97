// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

#include <string_view>

namespace dewpoint::trajectory {
struct ExportPreview;
struct ExportSummary;
} // namespace dewpoint::trajectory

namespace dewpoint::ui {

/// Returns the translated name of the export format with this id.
QString exportFormatName(std::string_view id);
/// Returns a text about the units of an export, for example "Lengths in mm, times in s. Y points
/// up: ..."
QString exportUnitsText(const ExportPreview& preview);
/// Returns a text about the size of an export, for example "2 targets, 180 rows at 30 per second,
/// 12 positions unknown".
QString exportSizeText(const ExportPreview& preview);
/// Returns a text about the result of an export, for example "Exported 180 rows to trajectory.csv."
/// The summary must have at least one file.
QString exportedText(const ExportSummary& summary);

} // namespace dewpoint::ui

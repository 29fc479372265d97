// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string_view>

namespace dewpoint {

struct ExportPreview;

/// Name of a format in the person's language.
QString exportFormatName(std::string_view id);
/// "Lengths in mm, times in s. Y points up: ..."
QString exportUnitsText(const ExportPreview& preview);
/// "2 targets, 180 rows at 30 per second, 12 places unknown"
QString exportSizeText(const ExportPreview& preview);

} // namespace dewpoint

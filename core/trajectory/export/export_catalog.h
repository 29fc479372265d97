// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/export/export_formats.h"

#include <span>
#include <string_view>

namespace dewpoint::trajectory {

/// All export formats, in the order of menus.
std::span<const ExportFormat> exportFormats();

/// The format of that id; NotFound lists the known ones.
Result<const ExportFormat*> exportFormat(std::string_view id);

} // namespace dewpoint::trajectory

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/export/export_formats.h"

#include <span>
#include <string_view>

namespace dewpoint::trajectory {

/// Returns all export formats, in menu order.
std::span<const ExportFormat> exportFormats();

/// Returns the format with this id. If there is none, returns NotFound, which lists the known ids.
Result<const ExportFormat*> findExportFormat(std::string_view id);

} // namespace dewpoint::trajectory

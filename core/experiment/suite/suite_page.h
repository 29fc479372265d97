// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_report.h"

#include <string>

namespace dewpoint::experiment {

/// Returns the report as a single self-contained HTML page with inline plots, for light and dark
/// mode.
std::string reportHtml(const SuiteReport& report);

} // namespace dewpoint::experiment

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_report.h"

#include <string>

namespace dewpoint::experiment {

/// The report as a single self-contained page: light and dark mode, inline plots.
std::string reportHtml(const SuiteReport& report);

} // namespace dewpoint::experiment

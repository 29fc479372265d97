// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_report.h"

#include <string>

namespace dewpoint::experiment {

/// One page that needs nothing else: light and dark, plots inline.
std::string reportHtml(const SuiteReport& report);

} // namespace dewpoint::experiment

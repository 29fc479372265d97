// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"

#include <vector>

namespace dewpoint::experiment {

/// All rendered scenarios in the order of the report.
const std::vector<ScenarioDeclaration>& scenarioCatalog();

} // namespace dewpoint::experiment

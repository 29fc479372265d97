// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"

#include <vector>

namespace dewpoint::experiment {

/// Returns all rendered scenarios in report order.
const std::vector<ScenarioDeclaration>& scenarioCatalog();

} // namespace dewpoint::experiment

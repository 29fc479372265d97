// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/evaluation.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// Returns a human-readable summary with a few lines per target, in millimeters.
std::string evaluationText(const std::vector<Evaluation>& evaluations);
/// Returns evaluations as JSON, in meters: {"unit": "m", "targets": [...]}.
nlohmann::json evaluationJson(const std::vector<Evaluation>& evaluations);

} // namespace dewpoint::trajectory

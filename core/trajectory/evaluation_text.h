// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/evaluation.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// Some lines per target for people, in millimeters.
std::string evaluationText(const std::vector<Evaluation>& evaluations);
/// The same numbers for programs, in meters: {"unit": "m", "targets": [...]}.
nlohmann::json evaluationJson(const std::vector<Evaluation>& evaluations);

} // namespace dewpoint::trajectory

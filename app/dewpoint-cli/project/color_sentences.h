// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::app {

/// Returns "Hue 321 to 353 degrees, saturation 0.20 to 1.00, intensity 0.10 to 0.93."
std::string rangeSentence(const ColorRange& range);

/// Returns one sentence each: how well the color stands out, what else matches it and where, and
/// what to do about it. `cameras`: names in the order of the project.
std::vector<std::string> assessmentSentences(const ColorAssessment& assessment,
                                             const std::vector<std::string>& cameras);

/// Returns what the click shows about the radius of the target (meters) if that differs from
/// `given` (0: unknown); empty if they agree or if the click shows no radius.
std::string radiusSentence(double given, const std::optional<double>& shown);

} // namespace dewpoint::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::app {

/// "Hue 321 to 353 degrees, saturation 0.20 to 1.00, intensity 0.10 to 0.93."
std::string rangeSentence(const ColorRange& range);

/// How well the color stands out, what matches too and where, and what to do about it: a sentence
/// each. `cameras` are the names, in the order of the project.
std::vector<std::string> assessmentSentences(const ColorAssessment& assessment,
                                             const std::vector<std::string>& cameras);

/// What the click shows of the target's radius (meters), where that is not the one `given` (0:
/// unknown); empty where they agree or none is shown.
std::string radiusSentence(double given, const std::optional<double>& shown);

} // namespace dewpoint::app

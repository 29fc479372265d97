// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::app {

/// Returns a color range as text: "Hue 321 to 353 degrees, saturation 0.20 to 1.00, intensity 0.10
/// to 0.93."
std::string describeRange(const ColorRange& range);

/// Returns sentences that describe how well the color stands out, what else matches it and where,
/// and what to do about it. `cameras` has the camera names in project order.
std::vector<std::string> describeAssessment(const ColorAssessment& assessment,
                                            const std::vector<std::string>& cameras);

/// Returns a sentence about the target radius found at the click, `shown` (meters), if it differs
/// from the radius in the project, `given` (meters; 0: unknown). Returns an empty string if they
/// agree or if no radius was found.
std::string describeRadius(double given, const std::optional<double>& shown);

} // namespace dewpoint::app

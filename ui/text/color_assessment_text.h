// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"

#include <QString>

#include <vector>

namespace dewpoint::ui {

/// Returns the assessment of a color range in sentences. `cameras` are the camera names.
QString colorAssessmentText(const ColorAssessment& assessment, const std::vector<QString>& cameras);

/// Returns the name of a color: "red", "turquoise", ...
QString colorName(ColorName color);

} // namespace dewpoint::ui

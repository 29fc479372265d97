// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"

#include <QString>

#include <vector>

namespace dewpoint::ui {

/// The quality of a color range in sentences; `cameras` are the names of the cameras.
QString colorAssessmentText(const ColorAssessment& assessment, const std::vector<QString>& cameras);

/// "red", "turquoise", ...
QString colorName(ColorWord color);

} // namespace dewpoint::ui

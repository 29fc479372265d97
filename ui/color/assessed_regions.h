// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"
#include "core/setup/click_lesson.h"
#include "ui/cameraview/image_pick_tool.h"

#include <map>
#include <vector>

namespace dewpoint::ui {

/// What is outlined in each camera beside the verdict about a color: what matches it too, and what
/// was found to be the target as well.
std::map<int, std::vector<ImagePickOverlay::Region>>
assessedRegions(const ColorAssessment& assessment, const std::vector<setup::FoundOutline>& found);

} // namespace dewpoint::ui

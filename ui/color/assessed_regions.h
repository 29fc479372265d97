// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_learning.h"
#include "core/setup/clicks/click_learning.h"
#include "ui/cameraview/image_pick_tool.h"

#include <map>
#include <vector>

namespace dewpoint::ui {

/// Returns, for each camera, the outlines to draw for a color assessment: the outlines of other
/// objects that match the color, and `found`, the outlines of further regions of the target itself.
std::map<int, std::vector<ImagePickOverlay::Region>>
assessedRegions(const ColorAssessment& assessment, const std::vector<setup::FoundOutline>& found);

} // namespace dewpoint::ui

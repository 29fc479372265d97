// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/camera_overlay.h"
#include "ui/cameraview/overlay_painter.h"

#include <vector>

namespace dewpoint::ui {

/// Draws what one camera says of the places around a target (dark: surely not, bright: surely), and
/// the places that were considered: solid circles for those believed in, dashed for new ones,
/// dotted for look-alikes.
void paintEvidence(QPainter& painter, const LikelihoodMap& map,
                   const std::vector<ProposedOutline>& proposed, const ImagePlacement& placement);

} // namespace dewpoint::ui

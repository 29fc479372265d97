// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/view/camera_overlay.h"
#include "ui/cameraview/overlay_painter.h"

#include <QImage>
#include <QRect>

#include <vector>

namespace dewpoint::ui {

/// Draws the likelihood map of a target, `map` (from `likelihoodImage()`; null for none), over the
/// area `place` of the camera image (pixels). Also draws the candidate positions as circles: solid
/// for existing ones, dashed for new ones, dotted for distractors.
void paintLikelihoodMap(QPainter& painter, const QRect& place, const QImage& map,
                        const std::vector<ProposedOutline>& proposed,
                        const ImagePlacement& placement);

} // namespace dewpoint::ui

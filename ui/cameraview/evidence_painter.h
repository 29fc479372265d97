// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/camera_overlay.h"
#include "ui/cameraview/overlay_painter.h"

#include <QImage>
#include <QRect>

#include <vector>

namespace dewpoint::ui {

/// Draws a target's likelihood map (`likelihoodImage()`; null for none) at its position in the
/// camera image (`place`, pixels). Also draws the candidate positions as circles: solid for
/// existing ones, dashed for new ones, dotted for distractors.
void paintLikelihoodMap(QPainter& painter, const QRect& place, const QImage& map,
                        const std::vector<ProposedOutline>& proposed,
                        const ImagePlacement& placement);

} // namespace dewpoint::ui

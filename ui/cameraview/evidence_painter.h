// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/camera_overlay.h"
#include "ui/cameraview/overlay_painter.h"

#include <QImage>
#include <QRect>

#include <vector>

namespace dewpoint::ui {

/// Draws the likelihood map of a target (`likelihoodImage()`; null: none) at its place in the image
/// of the camera (`place`, pixels), and the candidate positions: solid circles for accepted ones,
/// dashed for new ones, dotted for distractors.
void paintEvidence(QPainter& painter, const QRect& place, const QImage& map,
                   const std::vector<ProposedOutline>& proposed, const ImagePlacement& placement);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/camera_overlay.h"
#include "ui/cameraview/overlay_painter.h"

#include <QImage>
#include <QRect>

#include <vector>

namespace dewpoint::ui {

/// Draws the likelihood map of a target (likelihoodImage(); null: there is none) at its position in
/// the camera's image, pixels, and the positions that were considered: solid circles for those
/// believed in, dashed for new ones, dotted for distractors.
void paintEvidence(QPainter& painter, const QRect& place, const QImage& map,
                   const std::vector<ProposedOutline>& proposed, const ImagePlacement& placement);

} // namespace dewpoint::ui

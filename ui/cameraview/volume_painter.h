// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"
#include "ui/cameraview/overlay_painter.h"

namespace dewpoint::ui {

/// Draws the edges of the volume of interest as the camera sees them. The lines are thin, dashed
/// and semi-transparent, so that the image stays readable.
void paintVolume(QPainter& painter, const Camera& camera, const WorldBox& volume,
                 const ImagePlacement& placement);

} // namespace dewpoint::ui

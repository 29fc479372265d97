// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_placement.h"
#include "ui/cameraview/particle_ramp.h"

#include <QColor>

class QPainter;

namespace dewpoint::session {
struct CameraOverlay;
struct ImageEllipse;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Draws the particles and estimates of a target over the image of one camera, as thin bright lines
/// with a dark halo, readable on any image. The lines have the color `color`; `ramp` colors the
/// particles by weight.
void paintOverlay(QPainter& painter, const CameraOverlay& overlay, const ImagePlacement& placement,
                  const QColor& color, const ParticleRamp& ramp);

/// Draws the outline of an ellipse with the current pen of the painter.
void paintEllipse(QPainter& painter, const ImageEllipse& ellipse, const ImagePlacement& placement);

} // namespace dewpoint::ui

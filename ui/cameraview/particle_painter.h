// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_placement.h"
#include "ui/cameraview/particle_ramp.h"

class QPainter;

namespace dewpoint::session {
struct CameraOverlay;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Draws a target's particles as dots with a dark halo, colored by weight. The particles with the
/// highest weights are drawn last. If there are few particles, those with higher weights are drawn
/// larger.
void paintParticles(QPainter& painter, const CameraOverlay& overlay,
                    const ImagePlacement& placement, const ParticleRamp& ramp);

} // namespace dewpoint::ui

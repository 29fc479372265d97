// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/cameraview/overlay_painter.h"

#include <QRectF>

namespace dewpoint::ui {

/// Draws the people of a snapshot as one camera sees them: the outline of the hull of each 95 %
/// volume (Mohedano et al. 2009, figure 1) in the color of the identity, with its number. Draws
/// points where there are no hulls. `room` is the area of the image; `chosen` is the selected
/// target, or -1.
void paintPeople(QPainter& painter, const TrackSnapshot& snapshot, int camera,
                 const ImagePlacement& placement, const QRectF& room, int chosen);

/// Whether `paintPeople()` draws everything there is to draw of a target.
bool isPaintedByPeople(const TargetSnapshot& target);

/// Draws, at the lower edge of the image, what keeps a camera from detecting people, with a
/// progress bar while it learns. Draws nothing if people can be detected.
void paintPeopleTrouble(QPainter& painter, const TrackSnapshot& snapshot, int camera,
                        const QRectF& room);

} // namespace dewpoint::ui

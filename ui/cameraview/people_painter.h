// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/cameraview/overlay_painter.h"

#include <QRectF>

namespace dewpoint::ui {

/// Draws the people of a snapshot as one camera sees them: the outline of the hull of each 95 %
/// volume (Mohedano et al. 2009, figure 1) in the color of the identity, with its number; without
/// hulls, the points. `room` is where the image lies; `chosen` is the selected target, or -1.
void paintPeople(QPainter& painter, const TrackSnapshot& snapshot, int camera,
                 const ImagePlacement& placement, const QRectF& room, int chosen);

/// Whether paintPeople() draws all there is of a target.
bool isPaintedByPeople(const TargetSnapshot& target);

/// What keeps a camera from detecting people, at the lower edge of its image, with a bar while it
/// learns; nothing is drawn when nothing does.
void paintPeopleTrouble(QPainter& painter, const TrackSnapshot& snapshot, int camera,
                        const QRectF& room);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/cameraview/overlay_painter.h"

#include <QRectF>

namespace dewpoint::ui {

/// Draws the people in a snapshot as one camera sees them: the outline of each person's hull (the
/// 95 % volume; Mohedano et al. 2009, figure 1) in the identity color, with the identity number.
/// Draws points for a person without a hull. `room` is the image area; `chosen` is the selected
/// target (-1 if none).
void paintPeople(QPainter& painter, const TrackSnapshot& snapshot, int camera,
                 const ImagePlacement& placement, const QRectF& room, int chosen);

/// Returns whether `paintPeople()` draws this target, so that no other painter needs to draw it.
bool isPaintedAsPerson(const TargetSnapshot& target);

/// Draws, at the lower edge of the image, the reason why a camera cannot detect people, with a
/// progress bar while it learns the background. Draws nothing if people can be detected.
void paintPeopleProblem(QPainter& painter, const TrackSnapshot& snapshot, int camera,
                        const QRectF& room);

} // namespace dewpoint::ui

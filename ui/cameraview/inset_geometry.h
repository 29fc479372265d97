// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPointF>
#include <QRectF>

#include <optional>
#include <vector>

namespace dewpoint::ui {

// Where the inset of a camera view lies, and how much it enlarges. All of it depends on what is
// shown alone, so that the same frame is the same picture again, and it changes seldom, so that the
// inset rests while the cloud in it moves.

/// Whether a cloud of this diameter, widget units, is too small to be seen without an inset.
bool isTightCloud(double diameter);

/// The side of a square inset for a view of this area, widget units; nothing where it would be in
/// the way.
std::optional<double> insetSide(const QRectF& area);

/// How many device pixels a pixel of the image is wide in an inset of `side` device pixels, for a
/// cloud of this diameter in pixels of the image: a power of three. Nothing where the cloud is too
/// large for an inset of whole pixels.
std::optional<int> insetFactor(double diameter, double side);

/// A square in a corner of a view's area: the first one with ample room to the target, from the
/// lower left on, else the farthest; it touches none of what is `taken` if it can.
QRectF insetPlace(const QRectF& area, double side, const QPointF& target,
                  const std::vector<QRectF>& taken);

/// The longest length (pixels of the image) of 1, 2 or 5 times a power of ten that is at most
/// `longest` widget units long, where a pixel is `scale` wide.
double scaleBarLength(double scale, double longest);

} // namespace dewpoint::ui

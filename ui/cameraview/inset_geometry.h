// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPointF>
#include <QRectF>

#include <optional>
#include <vector>

namespace dewpoint::ui {

// Position and magnification of the inset in a camera view. They depend only on what is shown, so
// the same frame always gives the same image. They change rarely, so the inset stays still while
// the cloud in it moves.

/// Returns whether a cloud of this diameter (widget units) is too small to see without an inset.
bool isTightCloud(double diameter);

/// Returns the side length of the square inset for a view of this area (widget units), or nothing
/// if an inset would take up too much room.
std::optional<double> insetSide(const QRectF& area);

/// Returns the width of an image pixel in device pixels, for an inset with side length `side`
/// (device pixels) and a cloud of `diameter` image pixels. The result is a power of three. Returns
/// nothing if the cloud is too large for an inset of whole pixels.
std::optional<int> insetFactor(double diameter, double side);

/// Returns a square in a corner of the view area. It is the first corner, starting at the lower
/// left, that is far enough from the target; if there is none, it is the farthest corner. Corners
/// that overlap the `taken` rectangles are avoided if possible.
QRectF insetRect(const QRectF& area, double side, const QPointF& target,
                 const std::vector<QRectF>& taken);

/// Returns the longest length (image pixels) of the form 1, 2 or 5 times a power of ten that is at
/// most `longest` widget units long. `scale` is in widget units per pixel.
double scaleBarLength(double scale, double longest);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPointF>
#include <QRectF>

#include <optional>
#include <vector>

namespace dewpoint::ui {

// Position and magnification of the inset in a camera view. They depend only on the frame and the
// view, so the same frame always gives the same image. They change rarely, so that the inset does
// not move with the cloud.

/// Returns whether a particle cloud of this diameter (widget units) is too small to see without an
/// inset, a square in which it is enlarged.
bool isTightCloud(double diameter);

/// Returns the side length of the square inset, which shows a particle cloud enlarged, for a view
/// of this area (widget units), or nothing if an inset would take up too much room.
std::optional<double> insetSideLength(const QRectF& area);

/// Returns the magnification of an inset: the width of an image pixel in device pixels, a power of
/// three. The inset has the side length `side` (device pixels), and the particle cloud in it a
/// diameter of `diameter` image pixels. Returns nothing if the cloud is too large for an inset.
std::optional<int> insetMagnification(double diameter, double side);

/// Returns the square for the inset that shows the target enlarged, in a corner of the view area:
/// the first corner, starting at the lower left, that is far enough from the target, or else the
/// farthest corner. Corners that overlap the `taken` rectangles are avoided if possible.
QRectF insetRect(const QRectF& area, double side, const QPointF& target,
                 const std::vector<QRectF>& taken);

/// Returns the length of a scale bar, in image pixels: the largest number of the form 1, 2 or 5
/// times a power of ten for which the bar is at most `longest` widget units long. `scale` is in
/// widget units per image pixel.
double scaleBarLength(double scale, double longest);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPointF>
#include <QRectF>

#include <optional>
#include <vector>

namespace dewpoint::ui {

// Where the inset of a camera view lies, and how much it enlarges. All of it changes as seldom as
// it can, so that the inset rests while the cloud in it moves.

/// Whether a cloud of this diameter, widget units, is too small to be seen without an inset;
/// `wasTight`: it was before.
bool isTightCloud(double diameter, bool wasTight);

/// The side of a square inset for a view of this area, widget units; nothing where it would be in
/// the way.
std::optional<double> insetSide(const QRectF& area);

/// How many device pixels a pixel of the image is wide in an inset of `side` device pixels, for a
/// cloud of this diameter in pixels of the image: `before` as long as the cloud fills it neither
/// too little nor too much. Nothing where the cloud is too large for an inset of whole pixels.
std::optional<int> insetFactor(double diameter, double side, std::optional<int> before);

/// A square in a corner of a view's area: the nearest one with ample room to the target, or the
/// corner `before` (0 to 3) as long as the target keeps away from it; it touches none of what is
/// `taken` if it can.
struct InsetPlace {
  int corner = 0;
  QRectF square;
};
InsetPlace insetPlace(const QRectF& area, double side, const QPointF& target,
                      const std::vector<QRectF>& taken, std::optional<int> before);

/// The longest length (pixels of the image) of 1, 2 or 5 times a power of ten that is at most
/// `longest` widget units long, where a pixel is `scale` wide.
double scaleBarLength(double scale, double longest);

} // namespace dewpoint::ui

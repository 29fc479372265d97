// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/map_look.h"

#include <QString>

class QPainter;
class QPalette;
class QRect;

namespace dewpoint::ui {

/// A length with its unit, as short as it is exact enough: "0.4 mm", "12 mm", "1.20 m".
QString shortLength(double metres);

/// A share (0 to 1) in percent: 100 only when nothing is left, 0 only when there is nothing.
QString shareText(double share);

/// What the colors of a map mean, in the upper right corner of `area`.
void paintMapLegend(QPainter& painter, const QRect& area, const MapLook& look,
                    const QPalette& palette);

} // namespace dewpoint::ui

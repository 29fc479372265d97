// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/map_look.h"

class QPainter;
class QPalette;
class QRect;

namespace dewpoint::ui {

/// Draws the color legend of a map in the upper right corner of `area`.
void paintMapLegend(QPainter& painter, const QRect& area, const MapOptions& look,
                    const QPalette& palette);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/timeline/timeline_painter.h"

namespace dewpoint::ui {

/// Draws a diamond in a target's ribbon (the band that shows its states) at each frame for which
/// the user set a correction.
void paintCorrections(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                      const TimelineRows& rows, const QPalette& palette);

} // namespace dewpoint::ui

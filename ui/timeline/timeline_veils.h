// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/timeline/timeline_painter.h"

namespace dewpoint::ui {

/// Pales what is known, but cannot be shown any more.
void paintForgotten(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                    const TimelineRows& rows, const QPalette& palette);

/// Pales and hatches the ribbons where the results are of earlier settings.
void paintOldResults(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                     const TimelineRows& rows, const QPalette& palette);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/timeline/timeline_painter.h"

namespace dewpoint::ui {

/// Draws a translucent veil over the frames whose results are known but can no longer be shown.
void paintForgottenFrames(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                          const TimelineRows& rows, const QPalette& palette);

/// Draws a hatched translucent veil over those parts of the ribbons (the bands that show the target
/// states) that show results from earlier settings.
void paintOldResults(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                     const TimelineRows& rows, const QPalette& palette);

} // namespace dewpoint::ui

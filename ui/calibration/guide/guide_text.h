// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_guide.h"

#include <QString>

namespace dewpoint::ui {

/// Texts about a way to calibrate.
struct WayText {
  QString title;
  QString needs; ///< what is needed for this way, and what it is good for
};
WayText wayText(CalibrationWay way);

/// Texts about a step.
struct StepText {
  QString name;  ///< one short word for the strip
  QString title; ///< what to do, in a few words
  QString how;   ///< how to do it
  QString open;  ///< text of the button that opens the page for the step
};
StepText stepText(GuideStep step);

/// Returns the progress of a step: "2 of 4 cameras, largest error 0.4 px".
QString progressText(GuideStep step, const StepProgress& progress);
/// Returns the progress of a step as one number for the strip: "2/4", "0.4 px"; empty if there is
/// none.
QString progressNumber(GuideStep step, const StepProgress& progress);

/// Returns what is known about a lens or a position: "board, ±0.4 px".
QString lensText(const PartStatus& lens);
QString poseText(const PartStatus& pose);
/// Returns what is known about the scale, and about the floor.
QString scaleText(const PartStatus& scale);
QString floorText(const PartStatus& floor, bool isUpright);

/// Returns a symbol for the knowledge of a part: "✓" measured, "○" given, "⚠" missing or poor.
QString knowledgeMark(const PartStatus& part);

} // namespace dewpoint::ui

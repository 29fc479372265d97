// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_guide.h"

#include <QString>

namespace dewpoint::ui {

/// Texts about a way (procedure) to calibrate.
struct ProcedureText {
  QString title;
  QString requirements; ///< what this way to calibrate requires, and when to use it
};
ProcedureText procedureText(CalibrationProcedure procedure);

/// Texts about a step of the calibration guide.
struct StepText {
  QString name;           ///< one short word for the row of steps
  QString title;          ///< what to do in this step, in a few words
  QString instructions;   ///< how to do this step
  QString openButtonText; ///< text of the button that opens the page for this step
};
StepText stepText(GuideStep step);

/// Returns the progress of a step as text, for example "2 of 4 cameras, largest error 0.4 px".
QString progressText(GuideStep step, const StepProgress& progress);
/// Returns the progress of a step as one number for the row of steps, for example "2/4" or "0.4
/// px"; empty if there is no number.
QString progressNumberText(GuideStep step, const StepProgress& progress);

/// Return what is known about the intrinsics and about the position of a camera, for example
/// "board, ±0.4 px".
QString lensText(const ItemStatus& lens);
QString poseText(const ItemStatus& pose);
/// Return what is known about the scale and about the floor of the room.
QString scaleText(const ItemStatus& scale);
QString floorText(const ItemStatus& floor, bool isUpright);

/// Returns a symbol for how a part of the calibration is known: "✓" measured, "○" given, "⚠"
/// missing or poor.
QString statusSymbol(const ItemStatus& part);

} // namespace dewpoint::ui

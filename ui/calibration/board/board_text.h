// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/board_guide.h"

#include <QString>

namespace dewpoint::ui {

class BoardCalibrator;

/// "upper left": a region of BoardCoverage.
QString regionText(int region);
/// "its left side nearer".
QString tiltText(BoardTilt tilt);

/// What to show to one camera next, in one line.
QString adviceText(const BoardGuideState::PerCamera& camera);
/// What to show next for the positions of the cameras.
QString pairText(const BoardCalibrator& calibrator, const RigGuidance::State& state);
/// "sharp" or "soft", with the width of edges.
QString sharpnessText(const BoardGuideState::PerCamera& camera, const GuidanceSettings& settings);
/// How well its lens is known so far, and how well it is to be.
QString lensAccuracyText(const BoardGuideState::PerCamera& camera,
                         const GuidanceSettings& settings);

/// In the phase of positions: whether it sees the board.
QString visibilityText(const BoardGuideState::PerCamera& camera);
/// How often it was seen together with other cameras, and how well its position is known so far.
QString positionAccuracyText(const BoardGuideState::PerCamera& camera);

/// The result in sentences: what was found, camera by camera, quality and remarks.
QString outcomeText(const BoardCalibrator& calibrator, const BoardOutcome& outcome);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_guide.h"

#include <QString>

namespace dewpoint::ui {

class BoardCalibrator;

/// Name of a region of `BoardCoverage`: "upper left".
QString regionText(int region);
/// Description of a tilt: "its left side nearer".
QString tiltText(BoardTilt tilt);

/// One line that tells the user which view to show to a camera next.
QString adviceText(const BoardGuideState::PerCamera& camera);
/// Tells the user which view to show next to determine the positions of the cameras.
QString pairText(const BoardCalibrator& calibrator, const RigGuidance::State& state);
/// "sharp" or "soft", with the width of the edges in pixels.
QString sharpnessText(const BoardGuideState::PerCamera& camera, const GuidanceSettings& settings);
/// Accuracy of the intrinsics of a camera so far, and the requested accuracy.
QString lensAccuracyText(const BoardGuideState::PerCamera& camera,
                         const GuidanceSettings& settings);

/// Whether a camera sees the board, in the phase that determines the poses.
QString visibilityText(const BoardGuideState::PerCamera& camera);
/// How often a camera saw the board together with other cameras, and how accurate its position is
/// so far.
QString positionAccuracyText(const BoardGuideState::PerCamera& camera);

/// Result in sentences: what was found for each camera, the quality, and remarks.
QString outcomeText(const BoardCalibrator& calibrator, const BoardOutcome& outcome);

} // namespace dewpoint::ui

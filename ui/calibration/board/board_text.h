// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_guide.h"

#include <QString>

namespace dewpoint::ui {

class BoardCalibrator;

/// Returns the name of a `BoardCoverage` region: "upper left".
QString regionText(int region);
/// Returns the description of a tilt: "its left side nearer".
QString tiltText(BoardTilt tilt);

/// Returns one line that tells the user which view to show to a camera next.
QString adviceText(const BoardGuideState::PerCamera& camera);
/// Returns one line that tells the user which view to show next so that the camera positions can be
/// determined.
QString pairText(const BoardCalibrator& calibrator, const RigGuidance::State& state);
/// Returns "sharp" or "soft", with the edge width in pixels.
QString sharpnessText(const BoardGuideState::PerCamera& camera, const GuidanceSettings& settings);
/// Returns the current accuracy of a camera's intrinsics and the requested accuracy.
QString lensAccuracyText(const BoardGuideState::PerCamera& camera,
                         const GuidanceSettings& settings);

/// Returns a text about whether a camera sees the board, for the phase in which poses are
/// calibrated.
QString visibilityText(const BoardGuideState::PerCamera& camera);
/// Returns how often a camera saw the board together with other cameras, and how accurate its
/// position is so far.
QString positionAccuracyText(const BoardGuideState::PerCamera& camera);

/// Returns the description of a board that was found: "a ChArUco board with 4 × 5 squares,
/// DICT_4X4_50, black and white exchanged".
QString guessedBoardText(const BoardGuess& guess);
/// Returns the question whether to use a board that was found.
QString proposalQuestion(const BoardGuess& guess);

/// Returns the question whether to mirror the images of the cameras that show the board mirrored.
QString mirroredQuestion(const BoardCalibrator& calibrator);

/// Returns the result in sentences: what was found for each camera, the quality, and remarks.
QString outcomeText(const BoardCalibrator& calibrator, const BoardOutcome& outcome);

} // namespace dewpoint::ui

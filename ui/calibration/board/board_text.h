// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_guide.h"

#include <QString>

namespace dewpoint::ui {

class BoardCalibrator;

/// Returns the name of a `BoardCoverage` region of the image, for example "upper left".
QString regionText(int region);
/// Returns the description of a tilt of the board, for example "its left side nearer".
QString tiltText(BoardTilt tilt);

/// Returns one line of advice for the user: which view of the board to show to a camera next.
QString adviceText(const BoardGuideState::PerCamera& camera);
/// Returns one line of advice for the user: which view of the board to show next so that the camera
/// positions can be determined.
QString cameraPairText(const BoardCalibrator& calibrator, const RigGuidance::State& state);
/// Returns "sharp" or "soft", with the edge width in pixels.
QString sharpnessText(const BoardGuideState::PerCamera& camera, const GuidanceSettings& settings);
/// Returns the current accuracy of a camera's intrinsics and the requested accuracy.
QString lensAccuracyText(const BoardGuideState::PerCamera& camera,
                         const GuidanceSettings& settings);

/// Returns a text that tells whether a camera sees the board, for the phase in which camera poses
/// are calibrated.
QString visibilityText(const BoardGuideState::PerCamera& camera);
/// Returns how often a camera saw the board together with other cameras, and how accurate its
/// position is so far.
QString positionAccuracyText(const BoardGuideState::PerCamera& camera);

/// Returns the description of a board that was found in images, for example "a ChArUco board with 4
/// × 5 squares, DICT_4X4_50, black and white exchanged".
QString guessedBoardText(const BoardGuess& guess);
/// Returns the question to the user whether to use a board that was found in images.
QString proposalQuestion(const BoardGuess& guess);

/// Returns the question to the user whether to mirror the images of the cameras that show the board
/// mirrored.
QString mirroredVideosQuestion(const BoardCalibrator& calibrator);

/// Returns the result of a calibration in sentences: what was found for each camera, the quality,
/// and remarks.
QString outcomeText(const BoardCalibrator& calibrator, const BoardOutcome& outcome);

} // namespace dewpoint::ui

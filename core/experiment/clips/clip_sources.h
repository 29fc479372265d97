// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/clips/clip_declaration.h"

#include <string>

namespace dewpoint::experiment {

/// `hand2_desk`: a hand over a desk, two cameras; 40 frames marked by hand (bench/clips/README.md).
/// Frames 12 to 363. Lengths in meters with a chessboard square of 0.03 m, see there.
Result<CalibratedClip> handClip(const ClipFolders& folders);

/// The same, of which one box around the hand says what the target is, where the other is clicked.
Result<CalibratedClip> boxedHandClip(const ClipFolders& folders);

/// `tapes2_limbs`: three colored bands on a man's knee, ankle and wrist, two cameras. The truth is
/// the bands' centers in the images. The length of the baseline is not known: kBandBaseline.
Result<CalibratedClip> bandsClip(const ClipFolders& folders);

/// `charuco4`: a board that a man waves, four cameras with their own time stamps. The truth is the
/// board's center from its published corners; instants in which that is not known have none.
Result<CalibratedClip> boardClip(const ClipFolders& folders);

/// Baseline of the cameras of tapes2_limbs, meters. Assumed: with it the distance of the bands at
/// knee and ankle, 0.763 baselines, is 0.46 m. Nothing is measured in meters on that clip.
inline constexpr double kBandBaseline = 0.6;

/// The clip of that name among recordedBoxClips(): NotFound where it is not.
Result<BoxClip> recordedBoxClip(const ClipFolders& folders, const std::string& name);

} // namespace dewpoint::experiment

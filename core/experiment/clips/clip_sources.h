// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/clips/clip_declaration.h"

#include <string>

namespace dewpoint::experiment {

/// `hand2_desk`: a hand over a desk, two cameras; 40 frames marked by hand (bench/clips/README.md).
/// Frames 12 to 363. Lengths in meters for a chessboard square of 0.03 m, see there.
Result<CalibratedClip> handClip(const ClipFolders& folders);

/// The same clip, but the target is learned from a box around the hand instead of a click.
Result<CalibratedClip> boxedHandClip(const ClipFolders& folders);

/// `tapes2_limbs`: three colored bands on a man's knee, ankle and wrist, two cameras. The truth is
/// the centers of the bands in the images. The length of the baseline is not known: kBandBaseline.
Result<CalibratedClip> bandsClip(const ClipFolders& folders);

/// `charuco4`: a board that a man waves, four cameras with their own time stamps. The truth is the
/// center of the board from its published corners. Instants without these corners have no truth.
Result<CalibratedClip> boardClip(const ClipFolders& folders);

/// Baseline of the cameras of tapes2_limbs, meters. Assumed: it makes the distance between the
/// bands at knee and ankle, 0.763 baselines, 0.46 m. No length was measured in meters on that clip.
inline constexpr double kBandBaseline = 0.6;

/// Returns the clip of that name among recordedBoxClips(); NotFound if there is none.
Result<BoxClip> recordedBoxClip(const ClipFolders& folders, const std::string& name);

} // namespace dewpoint::experiment

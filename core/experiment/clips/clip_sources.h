// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/clips/clip_declaration.h"

#include <string>

namespace dewpoint::experiment {

/// Loads `hand2_desk`: a hand over a desk, two cameras, frames 12 to 363. The hand is marked
/// manually in 40 frames (bench/clips/README.md). Lengths in meters assume a chessboard square of
/// 0.03 m; see the same file.
Result<CalibratedClip> handClip(const ClipFolders& folders);

/// Loads the same clip as handClip() (a hand over a desk, two cameras), but the target is learned
/// from a box around the hand instead of a click.
Result<CalibratedClip> boxedHandClip(const ClipFolders& folders);

/// Loads `tapes2_limbs`: three colored bands on a man's knee, ankle and wrist, two cameras. The
/// truth consists of the band centers in the images. The true distance between the cameras is
/// unknown; see kBandBaseline.
Result<CalibratedClip> bandsClip(const ClipFolders& folders);

/// Loads `charuco4`: a man waves a board in front of four cameras that have separate time stamps.
/// The truth is the board center, computed from the published corners. Instants without these
/// corners have no truth.
Result<CalibratedClip> boardClip(const ClipFolders& folders);

/// Assumed distance between the two cameras of tapes2_limbs, meters. With this value, the distance
/// between the knee and ankle bands, which is 0.763 times the distance between the cameras, is 0.46
/// m. No length in that clip was measured in meters.
inline constexpr double kBandBaseline = 0.6;

/// Returns the recorded clip of one camera with this name, as read by recordedBoxClips(); NotFound
/// if there is none.
Result<BoxClip> recordedBoxClip(const ClipFolders& folders, const std::string& name);

} // namespace dewpoint::experiment

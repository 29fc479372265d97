// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dewpoint::simulation {

// Sampling density for moving bodies. The values were tuned; the reasons for them are not recorded.

/// Number of samples along each side of a pixel that shows a silhouette or the border between two
/// colors. Each sample covers a sixteenth of the pixel area.
inline constexpr int kEdgeSamples = 4;
/// Maximum number of times at which an exposure is sampled to draw motion blur. A body that moves
/// by more than 24 pixels during the exposure therefore moves by more than kPixelsPerInstant
/// between two of these times.
inline constexpr int kMaxInstants = 16;
/// Maximum distance in pixels that a body moves between two successive times at which an exposure
/// is sampled, unless kMaxInstants is reached. Chosen to be less than the blur of a lens.
inline constexpr double kPixelsPerInstant = 1.5;

} // namespace dewpoint::simulation

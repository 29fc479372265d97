// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dewpoint::simulation {

// Sampling density of moving bodies. Tuned; the origin of the numbers is not recorded.

/// Samples per side of a pixel on a silhouette or on the border between two colors; chosen: a
/// sixteenth of a pixel's area.
inline constexpr int kEdgeSamples = 4;
/// Largest number of instants of one exposure; chosen: blur of more than 24 pixels is sampled more
/// coarsely.
inline constexpr int kMostInstants = 16;
/// Pixels that a body travels between two instants; chosen: less than the blur of a lens.
inline constexpr double kPixelsPerInstant = 1.5;

} // namespace dewpoint::simulation

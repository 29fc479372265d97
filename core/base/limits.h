// SPDX-License-Identifier: GPL-3.0-or-later
// Upper limits for what a file may request. Every reader rejects larger values with one sentence,
// before it allocates anything. Each limit is far beyond any known use, and small enough for a
// laptop.
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <cstdint>

namespace dewpoint::base::limits {

/// Size of a text that is read as a whole, in bytes. A project with 100,000 corrections has 15 MiB.
inline constexpr std::uintmax_t kMostTextBytes = std::uintmax_t{64} << 20U;
/// Size of a table with one row per frame, in bytes. A trajectory of a day at 30 frames/s has 0.5
/// GiB.
inline constexpr std::uintmax_t kMostTableBytes = std::uintmax_t{4} << 30U;
/// Size of a calibration, in bytes. A calibration of 1000 cameras has less than 1 MiB, but the
/// objects that parsers build from a text take up to 200 times its size. Files of mrcal, which also
/// hold the data they were computed from, may have kMostTextBytes before that data is removed.
inline constexpr std::uintmax_t kMostCalibrationBytes = std::uintmax_t{4} << 20U;

/// Number of cameras in a project, calibration or scene. The largest motion capture stages have a
/// few hundred.
inline constexpr std::size_t kMostCameras = 1000;
/// Number of targets in a project, or of balls and lights in a scene.
inline constexpr std::size_t kMostTargets = 1000;
/// Width or height of an image, in pixels. Line cameras reach 32,768.
inline constexpr int kMostImageSide = 100'000;
/// Number of pixels in an image: 268 megapixels, while the largest cameras have 150. One such image
/// takes 0.8 GB.
inline constexpr std::int64_t kMostImagePixels = std::int64_t{1} << 28U;

/// Number of rows in a trajectory or table of times: four days at 30 frames/s. A row takes up to
/// 0.5 kB.
inline constexpr std::size_t kMostRows = 10'000'000;
/// Number of columns in a table. Tables of this program have fewer than 40.
inline constexpr std::size_t kMostColumns = 1000;
/// Number of comment lines kept from the head of a trajectory. It has one line per parameter.
inline constexpr std::size_t kMostHeaderEntries = 10'000;
/// Number of the last frame of a recording: ten years at 30 frames/s. The difference of two frame
/// numbers fits in any integer type.
inline constexpr std::int64_t kMostFrames = 10'000'000'000;

/// Number of parts in a TOML key ("a.b.c" has 3), and depth of nested brackets. Both cost stack
/// memory.
inline constexpr std::size_t kMostNesting = 64;

/// Returns whether an image of this size (pixels) is within the limits.
constexpr bool isImageSize(std::int64_t width, std::int64_t height) {
  return width >= 1 && height >= 1 && width <= kMostImageSide && height <= kMostImageSide &&
         width * height <= kMostImagePixels;
}

} // namespace dewpoint::base::limits

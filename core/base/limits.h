// SPDX-License-Identifier: GPL-3.0-or-later
// What a file may ask of the program at most. Every reader refuses more with one sentence, before
// it allocates anything. Each is far beyond what any use has needed, and small enough for a laptop.
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <cstdint>

namespace dewpoint::base::limits {

/// Bytes of a text that is read as a whole: a project with 100,000 corrections has 15 MiB.
inline constexpr std::uintmax_t kMostTextBytes = std::uintmax_t{64} << 20U;
/// Bytes of a table with a row per frame: a trajectory of a day at 30 frames/s has 0.5 GiB.
inline constexpr std::uintmax_t kMostTableBytes = std::uintmax_t{4} << 30U;
/// Bytes of a calibration: that of 1000 cameras has less than 1 MiB, and the objects that parsers
/// make of a text take up to 200 times its size. mrcal's files, which carry all that they were made
/// from, may have kMostTextBytes before that is cut out.
inline constexpr std::uintmax_t kMostCalibrationBytes = std::uintmax_t{4} << 20U;

/// Cameras of a project, calibration or scene: the largest motion capture stages have some
/// hundreds.
inline constexpr std::size_t kMostCameras = 1000;
/// Targets of a project, balls and lights of a scene.
inline constexpr std::size_t kMostTargets = 1000;
/// Width or height of an image, pixels: line cameras reach 32,768.
inline constexpr int kMostImageSide = 100'000;
/// Pixels of an image: 268 megapixels, where the largest cameras have 150. One takes 0.8 GB.
inline constexpr std::int64_t kMostImagePixels = std::int64_t{1} << 28U;

/// Rows of a trajectory or table of times, which take up to 0.5 kB each: four days at 30 frames/s.
inline constexpr std::size_t kMostRows = 10'000'000;
/// Columns of a table: ours have fewer than 40.
inline constexpr std::size_t kMostColumns = 1000;
/// Lines of comments in the head of a trajectory that are kept: a line per parameter.
inline constexpr std::size_t kMostHeaderEntries = 10'000;
/// The last frame of a recording: ten years at 30 frames/s. Differences of two fit in any integer.
inline constexpr std::int64_t kMostFrames = 10'000'000'000;

/// Parts of a key in TOML ("a.b.c" has 3), and nested brackets: both cost stack.
inline constexpr std::size_t kMostNesting = 64;

/// Whether an image of this size may be asked for.
constexpr bool isImageSize(std::int64_t width, std::int64_t height) {
  return width >= 1 && height >= 1 && width <= kMostImageSide && height <= kMostImageSide &&
         width * height <= kMostImagePixels;
}

} // namespace dewpoint::base::limits

// SPDX-License-Identifier: GPL-3.0-or-later
// Upper limits for the contents of files. Every reader rejects larger values with a one-sentence
// error before it allocates memory. Each limit is far beyond any known use, yet small enough for a
// laptop.
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <cstdint>

namespace dewpoint::base::limits {

/// Maximum size of a text file that is read as a whole, in bytes. A project with 100,000
/// corrections takes 15 MiB.
inline constexpr std::uintmax_t kMaxTextBytes = std::uintmax_t{64} << 20U;
/// Maximum size of a table with one row per frame, in bytes. A one-day trajectory at 30 frames/s
/// takes 0.5 GiB.
inline constexpr std::uintmax_t kMaxTableBytes = std::uintmax_t{4} << 30U;
/// Maximum size of a calibration, in bytes. A calibration of 1000 cameras takes less than 1 MiB,
/// but the objects that a parser builds from a text take up to 200 times the size of the text.
/// Files from mrcal, a calibration program, also contain the data from which the calibration was
/// computed. This data does not count towards the limit: a file with such data may have up to
/// kMaxTextBytes.
inline constexpr std::uintmax_t kMaxCalibrationBytes = std::uintmax_t{4} << 20U;
/// Maximum size of a JSON file about one run or take (a recording of live cameras), in bytes. Such
/// files have some kilobytes. The objects that the parser builds from a file take up to 30 times
/// the size of the file.
inline constexpr std::uintmax_t kMaxRecordBytes = std::uintmax_t{4} << 20U;

/// Maximum number of cameras in a project, calibration or simulated scene. The largest motion
/// capture stages have a few hundred.
inline constexpr std::size_t kMaxCameras = 1000;
/// Maximum number of targets in a project, or of balls and lights in a simulated scene.
inline constexpr std::size_t kMaxTargets = 1000;
/// Maximum total number of particles of all targets in a project. The filters for this number of
/// particles take some gigabytes of memory.
inline constexpr double kMaxParticles = 2e7;
/// Maximum width or height of an image, in pixels. Line-scan cameras reach 32,768.
inline constexpr int kMaxImageSide = 100'000;
/// Maximum number of pixels in an image: 268 megapixels. The largest cameras have 150 megapixels.
/// An image of the maximum size takes 0.8 GB.
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 28U;

/// Maximum number of rows in a trajectory or table of times: four days at 30 frames/s. A row takes
/// up to 0.5 kB.
inline constexpr std::size_t kMaxRows = 10'000'000;
/// Maximum number of columns in a table. Tables written by this program have fewer than 40.
inline constexpr std::size_t kMaxColumns = 1000;
/// Maximum number of comment lines kept from the header of a trajectory. The header has one line
/// per parameter.
inline constexpr std::size_t kMaxHeaderEntries = 10'000;
/// Maximum frame number in a recording: ten years at 30 frames/s. The difference between two frame
/// numbers fits in a 64-bit integer.
inline constexpr std::int64_t kMaxFrames = 10'000'000'000;

/// Maximum number of parts in a TOML key ("a.b.c" has 3), and maximum depth of nested brackets.
/// Both are limited because the parser uses stack memory for each level.
inline constexpr std::size_t kMaxNesting = 64;

/// Returns whether an image of this size (pixels) is within the limits.
constexpr bool isImageSize(std::int64_t width, std::int64_t height) {
  return width >= 1 && height >= 1 && width <= kMaxImageSide && height <= kMaxImageSide &&
         width * height <= kMaxImagePixels;
}

} // namespace dewpoint::base::limits

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <array>
#include <compare>
#include <map>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Marker that was read in an image.
struct ReadMarker {
  int id = 0; ///< number in its dictionary
  /// Corners in pixels (pixel centers are at integers), clockwise from the marker's own upper left
  /// corner. For a mirrored reading they are those in the mirrored image.
  std::array<cv::Point2f, 4> corners;
};

/// How markers have to be read: with which code, and in which version of the image.
struct MarkerReading {
  int code = 0;          ///< index in markerCodes()
  bool inverted = false; ///< black and white are exchanged
  bool mirrored = false; ///< the image is mirrored left to right

  auto operator<=>(const MarkerReading&) const = default;
};

/// Returns the largest dictionary of each code. The smaller dictionaries of the same number of
/// cells (DICT_4X4_50, DICT_4X4_100, ...) begin with the same markers.
const std::vector<std::string>& markerCodes();

/// Reads all markers in an image (CV_8UC1) in every code, as they are, with black and white
/// exchanged (if too few are found as they are), and in the mirrored image. Only markers without
/// any wrong cell count. A reading contains each marker once, in ascending order of its number;
/// markers seen at two places are left out. Readings without markers are missing. Random patterns
/// are sometimes read as markers: what their positions have in common tells whether they are real.
std::map<MarkerReading, std::vector<ReadMarker>> readMarkersInAnyCode(const cv::Mat& gray);

} // namespace dewpoint::calibration

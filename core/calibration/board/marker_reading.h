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
  /// corner. If MarkerReading::isMirrored is true, they are positions in the mirrored image.
  std::array<cv::Point2f, 4> corners;
};

/// Code (family of dictionaries with equally many cells) with which markers were read, and the
/// version of the image in which they were read.
struct MarkerReading {
  int codeIndex = 0;       ///< index in markerCodes()
  bool isInverted = false; ///< black and white are exchanged
  bool isMirrored = false; ///< the image is mirrored left to right

  auto operator<=>(const MarkerReading&) const = default; // NOLINT(modernize-use-nullptr)
};

/// Returns the names of the largest dictionaries, one for each code. A code is a family of
/// dictionaries whose markers have the same number of cells (DICT_4X4_50, DICT_4X4_100, ...). The
/// smaller dictionaries of a code contain only the first markers of the largest one.
const std::vector<std::string>& markerCodes();

/// Reads all markers in an image (CV_8UC1), in every code (family of dictionaries whose markers
/// have the same number of cells). The image is read both as it is and mirrored. If too few markers
/// are found, it is also read with black and white exchanged. A marker counts only if all its cells
/// agree with the dictionary. The result contains the markers of each reading, in ascending order
/// of their numbers. A marker that is seen at two places is left out, as are readings without
/// markers. Random patterns are sometimes read as markers. Only the arrangement of the markers
/// shows whether they are real; see findMarkerGrids().
std::map<MarkerReading, std::vector<ReadMarker>> readMarkersInAnyCode(const cv::Mat& gray);

} // namespace dewpoint::calibration

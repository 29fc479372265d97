// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/marker_reading.h"

#include <vector>

namespace dewpoint::calibration {

/// Arrangement of the numbered markers of a ChArUco board.
struct MarkerGrid {
  int columns = 0;                 ///< squares in a row
  int rows = 0;                    ///< squares in a column, down to the lowest marker that was seen
  bool isFirstSquareWhite = false; ///< the first square is white and contains marker 0
  double markerToSquareRatio = 0.0; ///< side of a marker as a fraction of the side of a square
  int imageCount = 0;               ///< number of images that show the arrangement
  /// Number of detected markers, over all given images, whose positions agree with the arrangement.
  int markerCount = 0;
};

/// Finds the ChArUco board whose arrangement of squares puts the markers where the images show
/// them. `images` contains the markers that readMarkersInAnyCode() read in each image. If too few
/// rows were seen, up to three arrangements may be equally good. All of these are returned;
/// otherwise only the best one is returned. An image shows an arrangement if at least four markers
/// are where the arrangement puts them, with their sides along the grid. Returns an empty list if
/// the markers are not those of a ChArUco board.
std::vector<MarkerGrid> findMarkerGrids(const std::vector<std::vector<ReadMarker>>& images);

} // namespace dewpoint::calibration

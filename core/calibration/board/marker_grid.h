// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/marker_reading.h"

#include <vector>

namespace dewpoint::calibration {

/// Arrangement of the numbered markers of a ChArUco board.
struct MarkerGrid {
  int columns = 0;         ///< squares in a row
  int rows = 0;            ///< squares in a column, as far down as a marker was seen
  bool whiteFirst = false; ///< the first square is white and contains marker 0
  double markerPart = 0.0; ///< side of a marker as a part of the side of a square
  int images = 0;          ///< number of images that show the arrangement
  int markers = 0;         ///< number of markers in these images at their places
};

/// Finds the arrangements of squares that put the markers read in images (one list per image, from
/// readMarkersInAnyCode()) where they were seen. It is the best one; more, if several are equally
/// good because too few rows were seen. In an image at least four markers must be at their places,
/// with sides along the grid. Empty if the markers are those of no ChArUco board.
std::vector<MarkerGrid> findMarkerGrids(const std::vector<std::vector<ReadMarker>>& images);

} // namespace dewpoint::calibration

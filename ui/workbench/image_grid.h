// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QSizeF>

#include <span>
#include <vector>

namespace dewpoint::ui {

/// Grid of image views. View k is in column k % columns, below the earlier views of this column.
/// Within a column, all images have the same width. The columns have widths at which all are
/// equally high.
struct ImageGrid {
  int columnCount = 1;
  double imageArea = 0.0; ///< area covered by images, in square units of the available room
  double maximumUsefulWidth = 0.0;       ///< width beyond which no image grows
  std::vector<double> columnWidthShares; ///< fraction of the width, one per column; the sum is 1
  std::vector<double> viewHeightShares;  ///< fraction of the column height, one per view
};

/// Returns the grid with this number of columns (1 to the number of images). `aspects` are width /
/// height of each image, positive, at least one value. `room` is the size for all views together.
/// `title` is the height that each view needs in addition to its image.
ImageGrid imageGridOf(std::span<const double> aspects, const QSizeF& room, double title,
                      int columns);

/// Returns the grid in which images cover the largest area. The grid with `current` columns (0:
/// none yet) is kept unless another grid covers at least a tenth more, so that views do not jump
/// while the window is resized. `aspects` are width / height of each image, `room` is the size for
/// all views together, and `title` is the height that each view needs in addition to its image.
ImageGrid bestImageGrid(std::span<const double> aspects, const QSizeF& room, double title,
                        int current = 0);

} // namespace dewpoint::ui

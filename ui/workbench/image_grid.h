// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QSizeF>

#include <span>
#include <vector>

namespace dewpoint::ui {

/// Grid of image views: view k is in column k % columns, below earlier ones. Views in a column
/// share its height so that their images have the same width; columns share the width so that they
/// have the same height.
struct ImageGrid {
  int columns = 1;
  double area = 0.0;                ///< covered by images, square units of the room
  double usefulWidth = 0.0;         ///< width beyond which no image grows
  std::vector<double> columnShares; ///< share of the width, one per column; they add up to 1
  std::vector<double> heightShares; ///< share of the height of its column, one per view
};

/// Returns the grid with this number of columns (1 to the number of images). `aspects`: width /
/// height of each image, positive, at least one. `room`: size for all views together; `title`:
/// height that each view needs besides its image.
ImageGrid imageGridOf(std::span<const double> aspects, const QSizeF& room, double title,
                      int columns);

/// Returns the grid that covers the largest area with images. A grid of `current` columns (0: none
/// yet) is kept until another covers a tenth more, so that views do not jump while a window is
/// resized.
ImageGrid bestImageGrid(std::span<const double> aspects, const QSizeF& room, double title,
                        int current = 0);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QSizeF>

#include <span>
#include <vector>

namespace dewpoint::ui {

/// Views of images in columns: view k stands in column k % columns, below those before it. Views of
/// a column share its height so that their images are equally wide, and columns share the width so
/// that they are equally high.
struct ImageGrid {
  int columns = 1;
  double area = 0.0;                ///< covered by images, square units of the room
  double usefulWidth = 0.0;         ///< beyond it no image grows any more
  std::vector<double> columnShares; ///< of the width, one per column; together 1
  std::vector<double> heightShares; ///< of its column's height, one per view
};

/// The grid of so many columns (1 to the number of images). `aspects`: width / height of each
/// image, above 0, at least one. `room`: for all views together; `title`: the height that each view
/// needs beside its image.
ImageGrid imageGridOf(std::span<const double> aspects, const QSizeF& room, double title,
                      int columns);

/// The grid that covers most with images. One of `current` columns (0: there is none yet) stays
/// until another covers a tenth more, so that views do not jump about while a window is resized.
ImageGrid bestImageGrid(std::span<const double> aspects, const QSizeF& room, double title,
                        int current = 0);

} // namespace dewpoint::ui

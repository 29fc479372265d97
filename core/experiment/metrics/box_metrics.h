// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// Accuracy of followed boxes, over all frames after the first, whose box is given.
struct BoxFigures {
  /// Root mean square distance of the centers, px; if a follower has given up, its last box counts.
  double rmse = 0.0;
  double success = 0.0;   ///< area under the success curve, 0 to 1 (Wu, Lim and Yang 2013)
  double precision = 0.0; ///< share of the frames with the center within the radius
};

/// Compares the boxes found (nothing after a follower has given up) with the true ones, one per
/// frame from the first. `radius` is in pixels. The success curve is the share of frames whose
/// overlap exceeds a threshold, at 0, 0.05, ..., 1. Frames after giving up have an overlap of 0.
BoxFigures measureBoxes(std::span<const std::optional<ImageBox>> found,
                        std::span<const ImageBox> truth, double radius);

} // namespace dewpoint::experiment

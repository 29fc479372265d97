// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// Accuracy of followed boxes over all frames after the first, whose box is given.
struct BoxMetrics {
  double rmse = 0.0;    ///< root mean square distance between the centers, pixels; after a follower
                        ///< has given up, its last box counts
  double success = 0.0; ///< area under the success curve (Wu, Lim and Yang 2013)
  double precision = 0.0; ///< fraction of frames with the center within the radius
};

/// Compares the boxes found (nothing where a follower has given up) with the true boxes, one per
/// frame from the first frame on. `radius` is in pixels. The success curve is the fraction of
/// frames whose overlap is above a threshold, at 0, 0.05, ..., 1. Frames in which the follower has
/// given up have an overlap of 0.
BoxMetrics measureBoxes(std::span<const std::optional<ImageBox>> found,
                        std::span<const ImageBox> truth, double radius);

} // namespace dewpoint::experiment

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// How well boxes were followed, over all frames after the first, which is given.
struct BoxMetrics {
  double rmse = 0.0;      ///< root mean square distance of the centers, px; where a follower has
                          ///< given up, its last box counts
  double success = 0.0;   ///< area under the success curve (Wu, Lim and Yang 2013)
  double precision = 0.0; ///< share of the frames with the center within the radius
};

/// The boxes found (nothing where a follower has given up) against the true ones, one per frame
/// from the first. `radius`: pixels. The success curve is the share of frames whose overlap is
/// above a threshold, at 0, 0.05, ..., 1; frames that were given up overlap by 0.
BoxMetrics measureBoxes(std::span<const std::optional<ImageBox>> found,
                        std::span<const ImageBox> truth, double radius);

} // namespace dewpoint::experiment

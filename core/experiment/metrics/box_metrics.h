// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// Accuracy of tracked boxes over all frames after the first, whose box is given.
struct BoxMetrics {
  /// Root mean square distance between found and true centers, pixels. In frames in which the
  /// tracker has given up, its last box is used.
  double rmse = 0.0;
  /// Area under the success curve (Wu, Lim and Yang 2013): the mean, over overlap thresholds from 0
  /// to 1, of the fraction of frames whose overlap with the true box is above the threshold.
  double success = 0.0;
  /// Fraction of frames in which the found center is within `radius` pixels of the true center; see
  /// measureBoxes().
  double precision = 0.0;
};

/// Compares the boxes found by a tracker with the true boxes. Both lists have one entry per frame,
/// beginning with the first frame. An entry of `found` is empty if the tracker has given up; its
/// overlap counts as 0. The precision is the fraction of frames in which the found center is within
/// `radius` pixels of the true center. The success curve is the fraction of frames whose overlap is
/// above a threshold, for the thresholds 0, 0.05, ..., 1.
BoxMetrics measureBoxes(std::span<const std::optional<ImageBox>> found,
                        std::span<const ImageBox> truth, double radius);

} // namespace dewpoint::experiment

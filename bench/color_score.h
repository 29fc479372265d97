// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::bench {

/// Where a target is in an image, and which pixels count: masks, CV_8UC1.
struct ColorTruth {
  cv::Mat target;
  cv::Mat whole; ///< all but the rim, in which it is not known
  cv::Mat near;  ///< of these, what is around the target
};

/// How well the pixels of an image were divided, 0 to 1.
struct ColorScore {
  double strict = 0.0;  ///< F1, all pixels of the image
  double whole = 0.0;   ///< F1, all but the rim
  double near = 0.0;    ///< F1, all but the rim, around the target: is its shape right?
  double rocArea = 0.0; ///< all but the rim: how often a pixel of the target has a higher value
};

/// Of values (CV_8SC1) that are above 0 where a pixel is taken for the target's.
ColorScore colorScore(const cv::Mat& values, const ColorTruth& truth);

/// The medians, each measure for itself; 0 of none.
ColorScore medianOf(const std::vector<ColorScore>& scores);

} // namespace dewpoint::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// Extends a target's color range to the light in one image (CV_8UC3). In other light than when the
/// range was learned, the target may be darker, paler or shifted in hue, so that part of the target
/// no longer matches. A bound of `learned` is moved outward if two conditions hold. First, objects
/// that already match then match more completely, for example also on their shaded side. Second,
/// only few other pixels of the image start to match. Returns `learned` itself if nothing matches
/// or nothing is gained.
ColorRange extendRangeToLight(const ColorRange& learned, const cv::Mat& image);

} // namespace dewpoint::observation

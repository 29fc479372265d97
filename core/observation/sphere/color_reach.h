// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// Extends a target's color range to the light in one image. A range is learned in one light. In
/// another light, the target may be darker, paler or shifted in hue, so that part of it is outside
/// the range. A bound of `learned` is moved outward if two conditions hold. Objects that matched
/// before must then match more completely, for example also on their shaded side. And only few
/// other pixels of the image may newly match. `image` is CV_8UC3. Returns `learned` itself if
/// nothing matches or nothing is gained.
ColorRange extendRangeToLight(const ColorRange& learned, const cv::Mat& image);

} // namespace dewpoint::observation

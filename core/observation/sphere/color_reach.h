// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// How far a target's color reaches in the light of one image. A range is made in one light; in
/// another its target is darker, paler or of a shifted hue, and a part of it lies outside. Each
/// bound of `learned` is moved outward as long as what matches anew is joined to what matched
/// before (the shaded side of the same thing) and not scattered over the rest of the image. `image`
/// is CV_8UC3. Returns `learned` itself where nothing matches, or nothing is gained.
ColorRange reachInLight(const ColorRange& learned, const cv::Mat& image);

} // namespace dewpoint::observation

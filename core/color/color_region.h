// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"

#include <opencv2/core/types.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::color {

/// How unlike two colors are to something that is lit unevenly: in units of noise for what light
/// does not change (the shares of red, green and blue), and of half a natural logarithm for what it
/// does. 0 for equal colors; about 1 for neighboring pixels of one object, 5 for another object.
double colorDistance(const BgrColor& one, const BgrColor& other);

/// The object at a pixel: CV_8UC1 of the image's size, 255 on it.
///
/// Regions around the pixel are grown for every tolerance at once, by the least colorDistance that
/// has to be crossed to get somewhere (a flood from the click). Of these nested regions the one is
/// taken whose outline shows the strongest edge against the differences within it (Fisher's
/// criterion) and is not ragged; as with maximally stable regions (Matas et al., BMVC 2002) no
/// tolerance has to be chosen. On the whole it has about the clicked color. The click is then
/// corrected: the region's median color replaces that of the pixel. Highlights inside are filled.
///
/// `within` bounds it (a dragged box; without a clear outline in it, it is the box itself); empty:
/// the image.
cv::Mat growRegion(const cv::Mat& bgr, cv::Point click, cv::Rect within = {});

/// Share of a box that a thing in it fills at least: else the box is around something else. A
/// judgment.
inline constexpr double kLeastOfBox = 0.35;

/// The region of a sample in an image, as takeSample() grew it. Of a box without a clear outline in
/// it, as one that holds a part of something larger, it is what grows from its middle as far as it
/// lies in the box, if that is more than a third of it; else all of the box.
cv::Mat regionOfSample(const cv::Mat& bgr, const ColorSample& sample);

/// The colors of the pixels at which the mask (CV_8UC1, of the image's size) is not 0, row by row.
std::vector<BgrColor> colorsIn(const cv::Mat& bgr, const cv::Mat& mask);

/// The median per channel. At least one color.
BgrColor medianColor(std::vector<BgrColor> colors);

} // namespace dewpoint::color

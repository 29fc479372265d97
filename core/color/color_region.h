// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"

#include <opencv2/core/types.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::color {

/// Distance between two colors of an object that may be lit unevenly. Differences in chromaticity
/// (the shares of red, green and blue), which light does not change, count in units of noise;
/// differences in brightness count in units of half a natural logarithm. 0 for equal colors; about
/// 1 for neighboring pixels of one object, 5 for another object.
double colorDistance(const BgrColor& one, const BgrColor& other);

/// Segments the object at a pixel: CV_8UC1 of the image's size, 255 on the object.
///
/// Regions around the pixel are grown for all tolerances at once, by the smallest colorDistance
/// that has to be crossed to reach a pixel (a flood from the click). Of these nested regions, the
/// function takes the one whose outline has the strongest edge compared with the differences inside
/// it (Fisher's criterion), which is not ragged, and whose overall color is about the clicked one.
/// As with maximally stable regions (Matas et al., BMVC 2002), no tolerance has to be chosen. The
/// click is then corrected: the region's median color replaces that of the pixel. Highlights inside
/// the region are filled.
///
/// `within` bounds the region (a dragged box; if nothing in it has a clear outline, the region is
/// the box itself); empty: the whole image.
cv::Mat growRegion(const cv::Mat& bgr, cv::Point click, cv::Rect within = {});

/// Smallest share of a dragged box that an object in it must fill; with less, the region is the box
/// itself. A judgment.
inline constexpr double kLeastOfBox = 0.35;

/// Region of a sample in an image, as takeSample() grew it. For a box that has no clear outline in
/// it, such as one that contains a part of a larger object, it is the region grown from the center
/// of the box and cut off at the box, provided that this fills more than a third of the box; else
/// the whole box.
cv::Mat regionOfSample(const cv::Mat& bgr, const ColorSample& sample);

/// Colors of the pixels at which the mask (CV_8UC1, of the image's size) is not 0, row by row.
std::vector<BgrColor> colorsIn(const cv::Mat& bgr, const cv::Mat& mask);

/// Median of each channel. `colors`: at least one.
BgrColor medianColor(std::vector<BgrColor> colors);

} // namespace dewpoint::color

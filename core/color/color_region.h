// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"

#include <opencv2/core/types.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::color {

/// Returns the distance between two colors of an object that may be lit unevenly. Differences in
/// chromaticity (the fractions of red, green and blue), which lighting does not change, are
/// measured in units of noise. Differences in brightness are measured in units of half a natural
/// logarithm. The distance is 0 for equal colors, about 1 for neighboring pixels of one object, and
/// about 5 for a different object.
double colorDistance(const BgrColor& one, const BgrColor& other);

/// Segments the object at a pixel. Returns CV_8UC1 with the size of the image, 255 on the object.
///
/// For a given tolerance, the region consists of all pixels that are connected to the clicked pixel
/// by pixels whose colorDistance() to the clicked color is at most the tolerance. The regions of
/// all tolerances are nested, and they are found in one pass. The function selects a region with
/// three properties. Its outline has the strongest edge compared with the differences inside the
/// region (Fisher's criterion). Its outline is not ragged. Its overall color is close to the
/// clicked color. As with maximally stable regions (Matas et al., BMVC 2002), no tolerance has to
/// be chosen. The region is then grown again, with its median color in place of the color of the
/// clicked pixel. Highlights inside the region are filled.
///
/// `within` is a dragged box that limits the region, or empty for the whole image. If nothing in
/// the box has a clear outline, the region is the box itself.
cv::Mat growRegion(const cv::Mat& bgr, cv::Point click, cv::Rect within = {});

/// Minimum fraction of a dragged box that an object must fill. If the object fills less, the region
/// is the box itself. The value was chosen by judgment.
inline constexpr double kMinBoxFill = 0.35;

/// Returns the region of a sample in an image, as grown by takeSample(). If a box contains no clear
/// outline, for instance because it shows part of a larger object, the region is grown from the
/// center of the box and cut off at the box. This region is used if it fills at least kMinBoxFill
/// of the box. Otherwise the region is the whole box.
cv::Mat regionOfSample(const cv::Mat& bgr, const ColorSample& sample);

/// Returns the colors of the pixels where the mask (CV_8UC1, same size as the image) is not 0, row
/// by row.
std::vector<BgrColor> colorsIn(const cv::Mat& bgr, const cv::Mat& mask);

/// Returns the median of each channel. `colors` must contain at least one color.
BgrColor medianColor(std::vector<BgrColor> colors);

} // namespace dewpoint::color

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"
#include "core/color/likelihood/color_cells.h"
#include "core/color/likelihood/color_density.h"
#include "core/color/likelihood/color_likelihood.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::color {

/// How much a color in the image of a camera that was never shown the target speaks for it, from
/// colors of the target that another camera saw. Cameras differ in exposure and white balance, and
/// see other sides of an object in other light: the target's colors are spread by as much. What
/// many pixels of the image have speaks against it, so that a color counts by how rare it is there.
class OtherCameraLikelihood {
public:
  /// At least one color.
  explicit OtherCameraLikelihood(const std::vector<BgrColor>& target);

  /// The table of a camera by the pixels of its image (CV_8UC3). `near` (CV_8UC1 of its size): 255
  /// where the target may be; what is elsewhere cannot be taken for it, and counts a fifth. A large
  /// target speaks against itself.
  ColorLikelihood inImage(const cv::Mat& bgr, const cv::Mat& near) const;
  /// The mean log ratio (nats) of the pixels of `region` (CV_8UC1 of the image's size, 255 in it)
  /// by all others.
  double meanLogRatio(const cv::Mat& bgr, const cv::Mat& near, const cv::Mat& region) const;

private:
  std::vector<double> logRatios(const cv::Mat& bgr, const cv::Mat& near,
                                const cv::Mat& region) const;

  ColorDensity target_;
};

} // namespace dewpoint::color

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"
#include "core/color/likelihood/color_cells.h"
#include "core/color/likelihood/color_density.h"
#include "core/color/likelihood/color_likelihood.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::color {

/// Learns the color likelihood of a camera without samples from the target colors in another
/// camera. Cameras differ in exposure and white balance, and see different sides of an object in
/// different light. The target colors are spread to account for this. A color that many pixels of
/// the image have counts against the target. Colors that are rare in the image are therefore the
/// best evidence of the target.
class OtherCameraLikelihood {
public:
  /// `target`: colors of target pixels in the other camera, at least one.
  explicit OtherCameraLikelihood(const std::vector<BgrColor>& target);

  /// Returns the table for a camera, based on the pixels of its image (CV_8UC3). `near` (CV_8UC1 of
  /// the same size) is 255 where the target may be. All other pixels cannot be confused with the
  /// target, and count only a fifth. Because all pixels of the image count against the target,
  /// including its own, a large target gets lower values.
  ColorLikelihood likelihoodForImage(const cv::Mat& bgr, const cv::Mat& near) const;
  /// Returns the mean log ratio (nats) of the pixels in `region`, computed as if `region` were the
  /// target and all other pixels the rest. `region` is CV_8UC1 with the size of the image, 255
  /// inside.
  double meanLogRatio(const cv::Mat& bgr, const cv::Mat& near, const cv::Mat& region) const;

private:
  std::vector<double> logRatios(const cv::Mat& bgr, const cv::Mat& near,
                                const cv::Mat& region) const;

  ColorDensity target_;
};

} // namespace dewpoint::color

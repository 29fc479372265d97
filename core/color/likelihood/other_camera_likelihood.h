// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"
#include "core/color/likelihood/color_cells.h"
#include "core/color/likelihood/color_density.h"
#include "core/color/likelihood/color_likelihood.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::color {

/// Learns the color likelihood for a camera that has no samples, from the target colors in another
/// camera. Cameras differ in exposure and white balance, and see different sides of an object in
/// different light. The target colors are spread to account for these differences. Colors that are
/// common in the image count against the target, so rare colors are the best evidence of the
/// target.
class OtherCameraLikelihood {
public:
  /// Prepares the likelihood from `target`, the colors of target pixels in the other camera.
  /// `target` must contain at least one color.
  explicit OtherCameraLikelihood(const std::vector<BgrColor>& target);

  /// Returns the table for a camera, based on the pixels of its image `bgr` (CV_8UC3). `near`
  /// (CV_8UC1 of the same size) is 255 where the target may be. All other pixels cannot be confused
  /// with the target, so they get only a fifth of the weight. All pixels of the image count against
  /// the target, including the pixels of the target itself, so a large target gets lower values.
  ColorLikelihood likelihoodForImage(const cv::Mat& bgr, const cv::Mat& near) const;
  /// Returns the mean of log p(color | target) / p(color | not target) over the pixels of `region`,
  /// in nats. The density of the target comes from the other camera. The density of everything else
  /// is estimated from the pixels of `bgr` outside `region`. `near` is as for likelihoodForImage().
  /// `region` is CV_8UC1 of the size of the image, 255 inside.
  double meanLogLikelihoodRatio(const cv::Mat& bgr, const cv::Mat& near,
                                const cv::Mat& region) const;

private:
  std::vector<double> logRatios(const cv::Mat& bgr, const cv::Mat& near,
                                const cv::Mat& region) const;

  ColorDensity target_;
};

} // namespace dewpoint::color

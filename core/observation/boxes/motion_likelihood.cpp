// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/motion_likelihood.h"

#include "core/color/hsi.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <numbers>

namespace dewpoint::observation {
namespace {

double gaussian(double distance, double sigma) {
  const double scaled = distance / sigma;
  return std::exp(-0.5 * scaled * scaled) / (std::sqrt(2.0 * std::numbers::pi) * sigma);
}

} // namespace

void computeMotionLikelihood(const cv::Mat& mask, double sigma, double floor, cv::Mat& likelihood) {
  mask.convertTo(likelihood, CV_32FC1, 1.0 / 255.0);
  if (sigma > 0.0) {
    const int size = 2 * static_cast<int>(std::ceil(3.0 * sigma)) + 1;
    cv::GaussianBlur(likelihood, likelihood, cv::Size(size, size), sigma, sigma,
                     cv::BORDER_CONSTANT);
  }
  cv::max(likelihood, floor, likelihood);
}

double ColorCue::logLikelihood(const unsigned char* bgr, double hue, double saturation) const {
  const Eigen::Vector2d seen = hueAndSaturation(bgr);
  double hueDensity = 1.0;
  if (!std::isnan(seen[0])) {
    const double straight = std::abs(seen[0] - hue);
    hueDensity = gaussian(std::min(straight, 1.0 - straight), hueSigma);
  }
  const double saturationDensity = gaussian(seen[1] - saturation, saturationSigma);
  return std::log(minHueLikelihood + (1.0 - minHueLikelihood) * hueDensity) +
         std::log(minSaturationLikelihood + (1.0 - minSaturationLikelihood) * saturationDensity);
}

double ColorCue::minLogLikelihoodPerPixel() const {
  return std::log(minHueLikelihood) + std::log(minSaturationLikelihood);
}

Eigen::Vector2d hueAndSaturation(const unsigned char* bgr) {
  const Hsi color = hsiFromBgr(bgr[0], bgr[1], bgr[2]);
  return {color.hueDegrees / 360.0, color.saturation};
}

bool findNearestPixel(double column, double row, const cv::Mat& image, cv::Point& pixel) {
  // Written so that NaN is outside.
  if (!(column > -0.5 && column < image.cols - 0.5 && row > -0.5 && row < image.rows - 0.5)) {
    return false;
  }
  pixel = {static_cast<int>(std::lround(column)), static_cast<int>(std::lround(row))};
  return true;
}

} // namespace dewpoint::observation

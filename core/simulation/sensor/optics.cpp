// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/optics.h"

#include <opencv2/imgproc.hpp>

namespace dewpoint::simulation {

cv::Mat blurred(const cv::Mat& image, double sigmaPx) {
  if (sigmaPx <= 0.0) {
    return image;
  }
  cv::Mat result;
  cv::GaussianBlur(image, result, {}, sigmaPx, sigmaPx, cv::BORDER_REPLICATE);
  return result;
}

} // namespace dewpoint::simulation

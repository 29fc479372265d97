// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/image.h"

#include <opencv2/imgproc.hpp>

namespace dewpoint::ui {

QImage toQImage(const cv::Mat& bgr) {
  if (bgr.empty() || bgr.type() != CV_8UC3) {
    return {};
  }
  QImage image(bgr.cols, bgr.rows, QImage::Format_RGB32);
  // RGB32 lies in memory as blue, green, red, 255 on the little-endian machines we support.
  cv::Mat view(bgr.rows, bgr.cols, CV_8UC4, image.bits(),
               static_cast<std::size_t>(image.bytesPerLine()));
  cv::cvtColor(bgr, view, cv::COLOR_BGR2BGRA);
  return image;
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace cv {
class Mat;
}

namespace dewpoint {

/// A copy of a BGR image (CV_8UC3) as Format_RGB32, the format QPainter draws fastest.
QImage toImage(const cv::Mat& bgr);

} // namespace dewpoint

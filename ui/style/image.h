// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QImage>

namespace cv {
class Mat;
}

namespace dewpoint::ui {

/// Returns a copy of a BGR image (CV_8UC3) as Format_RGB32, which QPainter draws fastest.
QImage toQImage(const cv::Mat& bgr);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wiring/quiet_libraries.h"

#include <opencv2/core/utils/logger.hpp>

#include <cstdlib>

namespace dewpoint {

void quietLibraries() {
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  if (std::getenv("OPENCV_LOG_LEVEL") == nullptr) { // OpenCV has read its own before main
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_ERROR);
  }
}

} // namespace dewpoint

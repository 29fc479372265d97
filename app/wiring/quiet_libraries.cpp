// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wiring/quiet_libraries.h"

#include <opencv2/core/utils/logger.hpp>

#include <cstdlib>
#include <glog/logging.h>

namespace dewpoint::app {

void silenceLibraries() {
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  FLAGS_minloglevel = google::GLOG_FATAL;           // Ceres tells of every step it takes back
  if (std::getenv("OPENCV_LOG_LEVEL") == nullptr) { // OpenCV has read its own before main
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_ERROR);
  }
}

} // namespace dewpoint::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

namespace dewpoint::calibration {

/// Converts OpenCV's rotation vector and translation (three doubles each) to a pose.
Eigen::Isometry3d poseFromOpenCv(const cv::Mat& rotationVector, const cv::Mat& translation);

} // namespace dewpoint::calibration

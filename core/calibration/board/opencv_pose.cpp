// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/opencv_pose.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

namespace dewpoint::calibration {

Eigen::Isometry3d poseFromOpenCv(const cv::Mat& rotationVector, const cv::Mat& translation) {
  cv::Mat matrix;
  cv::Rodrigues(rotationVector, matrix);
  Eigen::Matrix3d rotation;
  Eigen::Vector3d shift;
  cv::cv2eigen(matrix, rotation);
  cv::cv2eigen(cv::Mat(translation.reshape(1, 3)), shift);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  pose.translation() = shift;
  return pose;
}

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_blobs.h"

#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace dewpoint::experiment {
namespace {

Eigen::Matrix3d covarianceOf(const std::vector<Bearing>& bearings, const Eigen::Vector3d& point) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const Bearing& bearing : bearings) {
    const double depth = (point - bearing.ray.origin).norm();
    const double sigma = kCenterSigmaPx * depth / bearing.focalLengthPx;
    information +=
        (Eigen::Matrix3d::Identity() - bearing.ray.direction * bearing.ray.direction.transpose()) /
        (sigma * sigma);
  }
  return information.inverse();
}

} // namespace

double Blob::radiusPx() const {
  return std::sqrt(static_cast<double>(areaPx) / std::numbers::pi);
}

std::vector<Blob> findBlobs(const cv::Mat& mask) {
  if (mask.empty()) {
    return {};
  }
  cv::Mat labels;
  cv::Mat statistics;
  cv::Mat centers;
  const int count = cv::connectedComponentsWithStats(mask, labels, statistics, centers, 8, CV_32S);
  std::vector<Blob> blobs;
  for (int label = 1; label < count; ++label) {
    const int area = statistics.at<int>(label, cv::CC_STAT_AREA);
    if (area >= kMinBlobArea) {
      blobs.push_back(
          {{centers.at<double>(label, 0), centers.at<double>(label, 1)},
           area,
           {statistics.at<int>(label, cv::CC_STAT_LEFT), statistics.at<int>(label, cv::CC_STAT_TOP),
            statistics.at<int>(label, cv::CC_STAT_WIDTH),
            statistics.at<int>(label, cv::CC_STAT_HEIGHT)}});
    }
  }
  std::ranges::sort(blobs, {}, [](const Blob& blob) {
    return std::tuple(-blob.areaPx, blob.center.y(), blob.center.x());
  });
  return blobs;
}

double residualPx(const Bearing& bearing, const Eigen::Vector3d& point) {
  const double depth = std::max(1e-9, (point - bearing.ray.origin).norm());
  return bearing.focalLengthPx * distanceToRay(bearing.ray, point) / depth;
}

std::optional<TriangulatedPoint> triangulate(std::vector<Bearing> bearings) {
  std::vector<Ray> rays;
  rays.reserve(bearings.size());
  for (const Bearing& bearing : bearings) {
    rays.push_back(bearing.ray);
  }
  const auto point = nearestPoint(rays);
  if (!point) {
    return std::nullopt;
  }
  TriangulatedPoint result;
  result.position = *point;
  result.covariance = covarianceOf(bearings, *point);
  for (const Bearing& bearing : bearings) {
    result.residualPx = std::max(result.residualPx, residualPx(bearing, *point));
  }
  result.bearings = std::move(bearings);
  return result;
}

} // namespace dewpoint::experiment

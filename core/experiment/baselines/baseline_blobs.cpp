// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_blobs.h"

#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace dewpoint::experiment {
namespace {

double distancePx(const Bearing& bearing, const Eigen::Vector3d& point) {
  const double depth = std::max(1e-9, (point - bearing.ray.origin).norm());
  return bearing.focalLength * distanceToRay(bearing.ray, point) / depth;
}

Eigen::Matrix3d covarianceOf(const std::vector<Bearing>& bearings, const Eigen::Vector3d& point) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const Bearing& bearing : bearings) {
    const double depth = (point - bearing.ray.origin).norm();
    const double sigma = kCenterSigmaPx * depth / bearing.focalLength;
    information +=
        (Eigen::Matrix3d::Identity() - bearing.ray.direction * bearing.ray.direction.transpose()) /
        (sigma * sigma);
  }
  return information.inverse();
}

/// The pair's place, joined by each further camera's blob that is nearest to it and fits.
std::optional<TriangulatedPoint> growPair(const std::vector<std::vector<Bearing>>& bearings,
                                          const Bearing& first, const Bearing& second,
                                          double gatePx) {
  auto position = triangulate({first, second});
  if (!position || position->residualPx > gatePx) {
    return std::nullopt;
  }
  for (std::size_t camera = 0; camera < bearings.size(); ++camera) {
    if (camera == first.camera || camera == second.camera || bearings[camera].empty()) {
      continue;
    }
    const auto nearest =
        std::ranges::min_element(bearings[camera], {}, [&](const Bearing& bearing) {
          return distancePx(bearing, position->position);
        });
    std::vector<Bearing> more = position->bearings;
    more.push_back(*nearest);
    auto joined = triangulate(std::move(more));
    if (joined && joined->residualPx <= gatePx) {
      position = std::move(joined);
    }
  }
  return position;
}

std::vector<TriangulatedPoint> allPositions(const std::vector<std::vector<Bearing>>& bearings,
                                            double gatePx) {
  std::vector<TriangulatedPoint> positions;
  for (std::size_t a = 0; a < bearings.size(); ++a) {
    for (std::size_t b = a + 1; b < bearings.size(); ++b) {
      for (const Bearing& first : bearings[a]) {
        for (const Bearing& second : bearings[b]) {
          if (auto position = growPair(bearings, first, second, gatePx)) {
            positions.push_back(std::move(*position));
          }
        }
      }
    }
  }
  return positions;
}

} // namespace

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
      blobs.push_back({{centers.at<double>(label, 0), centers.at<double>(label, 1)}, area});
    }
  }
  std::ranges::sort(blobs, {}, [](const Blob& blob) {
    return std::tuple(-blob.area, blob.center.y(), blob.center.x());
  });
  return blobs;
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
    result.residualPx = std::max(result.residualPx, distancePx(bearing, *point));
  }
  result.bearings = std::move(bearings);
  return result;
}

std::vector<TriangulatedPoint> triangulateMany(const std::vector<std::vector<Bearing>>& bearings,
                                               std::size_t count, double gatePx) {
  std::vector<TriangulatedPoint> positions = allPositions(bearings, gatePx);
  std::ranges::stable_sort(positions, [](const TriangulatedPoint& a, const TriangulatedPoint& b) {
    return a.bearings.size() != b.bearings.size() ? a.bearings.size() > b.bearings.size()
                                                  : a.residualPx < b.residualPx;
  });
  std::set<std::pair<std::size_t, std::size_t>> used;
  std::vector<TriangulatedPoint> picked;
  for (TriangulatedPoint& position : positions) {
    const bool free = std::ranges::none_of(position.bearings, [&](const Bearing& bearing) {
      return used.contains({bearing.camera, bearing.blob});
    });
    if (!free || picked.size() == count) {
      continue;
    }
    for (const Bearing& bearing : position.bearings) {
      used.insert({bearing.camera, bearing.blob});
    }
    picked.push_back(std::move(position));
  }
  return picked;
}

} // namespace dewpoint::experiment

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/reprojection_residuals.h"

#include "core/base/statistics.h"
#include "core/color/color_classifier.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::camera_motion {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr double kReach = 2.0;       // radii around the expected outline
constexpr double kLeastRadius = 2.0; // pixels
constexpr double kLeastShare = 0.6;  // of the outline's area
/// Of the outline's area: more is another object.
constexpr double kMostShare = 1.5;
constexpr int kLargestStep = 3;        // pixels between those looked at of a large target
constexpr double kPixelsAcross = 40.0; // as many are enough

} // namespace

std::optional<Eigen::Vector2d> findColorCentroid(const cv::Mat& image, const ColorRanges& color,
                                                 const SphereImage& expected) {
  const double reach = kReach * expected.radius;
  const int left = int(std::floor(expected.center.x() - reach));
  const int top = int(std::floor(expected.center.y() - reach));
  const int right = int(std::ceil(expected.center.x() + reach));
  const int bottom = int(std::ceil(expected.center.y() + reach));
  if (!(expected.radius >= kLeastRadius) || left < 0 || top < 0 || right >= image.cols ||
      bottom >= image.rows) {
    return std::nullopt;
  }
  const int step = std::clamp(int(2.0 * expected.radius / kPixelsAcross), 1, kLargestStep);
  const ColorClassifier classifier(color);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  int atEdge = 0;
  for (int row = top; row <= bottom; row += step) {
    const cv::Vec3b* pixels = image.ptr<cv::Vec3b>(row);
    for (int column = left; column <= right; column += step) {
      const cv::Vec3b& pixel = pixels[column];
      if (classifier.matches(pixel[0], pixel[1], pixel[2])) {
        sum += Eigen::Vector2d(column, row);
        ++count;
        atEdge += row == top || row + step > bottom || column == left || column + step > right;
      }
    }
  }
  const double area = std::numbers::pi * expected.radius * expected.radius / (step * step);
  if (count < kLeastShare * area || count > kMostShare * area || atEdge > 0) {
    return std::nullopt;
  }
  return sum / count;
}

ReprojectionResiduals::ReprojectionResiduals(const CameraRig& rig) : sightings_(rig.size()) {
  for (const Camera& camera : rig) {
    projectors_.emplace_back(camera);
    unprojectors_.emplace_back(camera);
  }
}

void ReprojectionResiduals::restart() {
  for (auto& one : sightings_) {
    one.clear();
  }
}

void ReprojectionResiduals::add(const FrameSet& frames, const std::vector<Target>& targets,
                                const std::vector<SphereEstimate>& estimates) {
  for (std::size_t k = 0; k < std::min(targets.size(), estimates.size()); ++k) {
    if (estimates[k].isValid && estimates[k].radius > 0.0) {
      addTarget(frames, targets[k], estimates[k]);
    }
  }
}

void ReprojectionResiduals::addTarget(const FrameSet& frames, const Target& target,
                                      const SphereEstimate& estimate) {
  const std::size_t count = std::min(projectors_.size(), frames.frames.size());
  std::vector<std::optional<Eigen::Vector2d>> centers(count);
  std::vector<std::optional<Ray>> rays(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto expected = projectors_[k].project(estimate.mean, estimate.radius);
    if (!expected || !frames.frames[k] || frames.frames[k]->image.type() != CV_8UC3) {
      continue;
    }
    centers[k] = findColorCentroid(frames.frames[k]->image, target.colors(), *expected);
    const auto point = projectors_[k].projector().project(estimate.mean);
    if (centers[k] && point) {
      *centers[k] += *point - expected->center; // from the outline's middle to the sphere's center
      rays[k] = unprojectors_[k].ray(*centers[k]);
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<Ray> others;
    for (std::size_t j = 0; j < count; ++j) {
      if (j != k && rays[j]) {
        others.push_back(*rays[j]);
      }
    }
    const auto world = count == 2 ? std::optional(estimate.mean) : nearestPoint(others);
    const auto pixel = world ? projectors_[k].projector().project(*world) : std::nullopt;
    if (centers[k] && pixel) {
      double otherCamerasDisagreementPx = 0.0;
      for (std::size_t j = 0; j < count; ++j) {
        const auto seen = projectors_[j].projector().project(*world);
        if (j != k && rays[j] && seen) {
          otherCamerasDisagreementPx =
              std::max(otherCamerasDisagreementPx, (*centers[j] - *seen).norm());
        }
      }
      sightings_[k].push_back({seconds(frames.time), *world, *centers[k], *centers[k] - *pixel,
                               otherCamerasDisagreementPx});
      if (sightings_[k].size() > kMaxResidualsPerCamera) {
        sightings_[k].pop_front();
      }
    }
  }
}

std::optional<ReprojectionResiduals::Summary>
ReprojectionResiduals::summarize(std::size_t camera, double since, std::size_t fewest) const {
  std::vector<double> columns, rows, others;
  for (const ReprojectionResidual& sighting : sightings_[camera]) {
    if (sighting.captureTime >= since) {
      columns.push_back(sighting.residual.x());
      rows.push_back(sighting.residual.y());
      others.push_back(sighting.otherCamerasDisagreementPx);
    }
  }
  if (columns.empty() || columns.size() < fewest) {
    return std::nullopt;
  }
  return Summary{{upperMedian(std::move(columns)), upperMedian(std::move(rows))},
                 upperMedian(std::move(others))};
}

} // namespace dewpoint::camera_motion

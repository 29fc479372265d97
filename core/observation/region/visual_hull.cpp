// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/visual_hull.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace dewpoint::observation {
namespace {

// Judgments (docs/method-dewpoint.md, section 12).

/// Samples along each axis, and semi-axes that they reach from the center: a cone's ends lie at 1.9
/// and 1.1 of those of the ellipsoid of its moments.
constexpr int kSamples = 15;
constexpr double kReach = 2.0;

struct Sample {
  Eigen::Vector3d point;
  bool left = true; ///< not excluded by a camera
};

std::vector<Sample> samplesAround(const Ellipsoid& around) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(around.extent);
  const Eigen::Matrix3d axes =
      solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  std::vector<Sample> samples;
  samples.reserve(static_cast<std::size_t>(kSamples * kSamples * kSamples));
  const auto at = [](int index) { return kReach * (2.0 * index / (kSamples - 1) - 1.0); };
  for (int i = 0; i < kSamples; ++i) {
    for (int j = 0; j < kSamples; ++j) {
      for (int k = 0; k < kSamples; ++k) {
        const Eigen::Vector3d unit(at(i), at(j), at(k));
        samples.push_back({around.center + axes * unit});
      }
    }
  }
  return samples;
}

/// Takes out what a camera does not see in the target's color.
void exclude(RegionObservation::View& view, const Eigen::Vector3d& offset,
             std::vector<Sample>& samples) {
  const cv::Rect image(cv::Point(0, 0), view.labels.size());
  std::vector<cv::Point> pixels(samples.size(), {-1, -1});
  cv::Rect all;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto pixel = samples[k].left
                           ? view.projector.projector().project(samples[k].point + offset)
                           : std::nullopt;
    if (pixel && pixel->cwiseAbs().maxCoeff() < 1e6) {
      pixels[k] = {static_cast<int>(std::lround(pixel->x())),
                   static_cast<int>(std::lround(pixel->y()))};
      all |= cv::Rect(pixels[k].x, pixels[k].y, 1, 1) & image;
    }
  }
  view.labels.require(all);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!samples[k].left || !image.contains(pixels[k])) {
      continue; // what lies outside the image may be there
    }
    const PixelLabel label = view.labels.at(pixels[k].x, pixels[k].y);
    samples[k].left = label == PixelLabel::Target || label == PixelLabel::Unknown ||
                      label == PixelLabel::Explained;
  }
}

} // namespace

std::optional<VisualHull> visualHull(RegionObservation& observation,
                                     const std::vector<RegionMeasurement>& views,
                                     const Ellipsoid& around, const Eigen::Vector3d& velocity) {
  if (std::ranges::count_if(views, [](const auto& view) { return view.region.has_value(); }) < 2) {
    return std::nullopt;
  }
  std::vector<Sample> samples = samplesAround(around);
  for (std::size_t k = 0; k < views.size(); ++k) {
    auto& view = observation.views()[k];
    if (views[k].region) {
      exclude(view, view.timeOffset * velocity, samples);
    }
  }
  VisualHull hull;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Sample& sample : samples) {
    if (sample.left) {
      const Eigen::Vector3d off = sample.point - around.center;
      ++hull.samples;
      hull.centroid += off;
      second += off * off.transpose();
    }
  }
  if (hull.samples == 0) {
    return std::nullopt;
  }
  hull.centroid /= hull.samples;
  second = second / hull.samples - hull.centroid * hull.centroid.transpose();
  // The second moments of a solid ellipsoid are a fifth of its extent.
  hull.extent = 5.0 * second;
  hull.centroid += around.center;
  return hull;
}

} // namespace dewpoint::observation

// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of scenarios count in the images of a run.
#pragma once

#include "core/base/time.h"
#include "core/color/match_image.h"
#include "core/experiment/scenarios/catalog/catalog.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/geometry/projector.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests {

inline ScenarioRun scenarioRun(const std::string& name, std::uint64_t seed = 1,
                               Grade grade = Grade::Ideal) {
  const auto& catalog = scenarioCatalog();
  const auto found = std::ranges::find(catalog, name, &ScenarioDeclaration::name);
  if (found == catalog.end()) {
    ADD_FAILURE() << "no scenario " << name;
    return {};
  }
  auto run = found->make(seed, grade);
  if (!run) {
    ADD_FAILURE() << name << ": no run";
    return {};
  }
  return *std::move(run);
}

/// Expects that two runs of one seed show the same images at a frame.
inline void expectSameBits(const std::string& name, std::int64_t frame) {
  const FrameSetPtr one = scenarioRun(name).frames(frame);
  const FrameSetPtr same = scenarioRun(name).frames(frame);
  for (std::size_t camera = 0; camera < one->frames.size(); ++camera) {
    EXPECT_EQ(cv::norm(one->frames[camera]->image, same->frames[camera]->image, cv::NORM_INF), 0.0)
        << name;
  }
}

/// Largest distance between the time stamps of the frames and of their sets in the first frames.
inline double largestStampError(const ScenarioRun& run) {
  double largest = 0.0;
  for (std::int64_t frame = 0; frame < 5; ++frame) {
    const FrameSetPtr set = run.frames(frame);
    for (const FramePtr& one : set->frames) {
      largest = one == nullptr ? largest
                               : std::max(largest, std::abs(seconds(one->captureTime - set->time)));
    }
  }
  return largest;
}

/// The targets' true positions at a frame, in the order of the targets.
inline std::vector<Eigen::Vector3d> truthAt(const ScenarioRun& run, std::int64_t frame) {
  std::vector<Eigen::Vector3d> positions;
  const auto first = static_cast<std::size_t>(frame) * run.targets.size();
  for (std::size_t k = first; k < first + run.targets.size(); ++k) {
    EXPECT_EQ(run.truth.samples.at(k).frame, frame);
    positions.push_back(run.truth.samples.at(k).position);
  }
  return positions;
}

/// A ball as a camera has it, pixels.
struct ImageDisc {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;
  double area() const { return std::numbers::pi * radius * radius; }
};

inline ImageDisc discOf(const Camera& camera, const Eigen::Vector3d& position, double radius) {
  const auto center = Projector(camera).project(position);
  const double depth = (camera.cameraFromWorld * position).z();
  EXPECT_TRUE(center.has_value());
  return {center.value_or(Eigen::Vector2d::Zero()), camera.intrinsics.focalX * radius / depth};
}

/// Pixels of a disc, as far as it is in the image, that are `wanted`.
template <class Wanted>
int countIn(const cv::Mat& image, const ImageDisc& disc, const Wanted& wanted) {
  int count = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const bool inside = (Eigen::Vector2d(column, row) - disc.center).norm() < disc.radius;
      count += inside && wanted(image.at<cv::Vec3b>(row, column)) ? 1 : 0;
    }
  }
  return count;
}

/// Pixels of a disc that match a color, per pixel of the whole disc.
inline double matchingShare(const cv::Mat& image, const ColorRange& color, const ImageDisc& disc) {
  const ColorClassifier classifier(color);
  const int count = countIn(image, disc, [&](const cv::Vec3b& pixel) {
    return classifier.matches(pixel[0], pixel[1], pixel[2]);
  });
  return count / disc.area();
}

} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/thread_team.h"
#include "core/geometry/image_box.h"
#include "core/tracking/parameters.h"
#include "core/tracking/track_estimate.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace dewpoint::tracking {

/// Filter that tracks one box in the images of one camera. MultiBoxTracker combines such filters
/// into a method. A filter is not thread-safe. The same seed gives bit-identical results for any
/// size of the ThreadTeam.
template <class F>
concept BoxFilter = std::copy_constructible<F> && std::constructible_from<F, ParameterValues> &&
    requires(F filter, const F& finished, const ParameterValues& parameters, const cv::Mat& bgr,
             const ImageBox& box, std::uint64_t seed, ThreadTeam& team, Eigen::ArrayXXd& centers,
             Eigen::ArrayXd& weights) {
  // Sets new parameters, which apply from the next image on.
  filter.configure(parameters);
  // Discards everything and starts tracking the content of a box in an image (CV_8UC3). Error:
  // BadValue with the field "image" or "box".
  { filter.start(bgr, box, seed) } -> std::same_as<Status>;
  // Processes the next image, which must have the same size. start() must have succeeded before.
  { filter.step(bgr, team) } -> std::same_as<BoxEstimate>;
  // Copies an even selection of at most this number of particles: the centers as rows of x and y,
  // and the latest linear weights, which sum to 1 over all particles.
  finished.copyParticles(0, centers, weights);
  // Returns the approximate size of a copy in bytes.
  { finished.memoryBytes() } -> std::same_as<std::size_t>;
};

/// Checks that the image is a color image, and that the box has at least 2 x 2 pixels and its
/// center in the image. Error: BadValue with the field "image" or "box".
Status checkBox(const cv::Mat& bgr, const ImageBox& box);

/// Returns the box around the object at the clicked pixel (x, y), found by its colors
/// (boxAroundClick()). Error: BadValue with the field "pixel" or "image".
Result<ImageBox> boxFromClick(const cv::Mat& bgr, double x, double y);

} // namespace dewpoint::tracking

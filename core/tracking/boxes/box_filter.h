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

/// A filter that follows one box through the images of one camera: what BoxTargets makes a method
/// of. Not thread safe; the same seed gives the same bits for any size of the ThreadTeam.
template <class F>
concept BoxFilter = std::copy_constructible<F> && std::constructible_from<F, ParameterValues> &&
    requires(F filter, const F& finished, const ParameterValues& parameters, const cv::Mat& bgr,
             const ImageBox& box, std::uint64_t seed, ThreadTeam& team, Eigen::ArrayXXd& centers,
             Eigen::ArrayXd& weights) {
  // Other parameters, from the next image on.
  filter.configure(parameters);
  // Takes what is in the box of an image (CV_8UC3) as what is to be followed,
  // and forgets everything else. BadValue names "image" or "box".
  { filter.start(bgr, box, seed) } -> std::same_as<Status>;
  // The next image, of the same size; start() must have succeeded.
  { filter.step(bgr, team) } -> std::same_as<BoxEstimate>;
  // The centers of at most that number of particles, evenly picked, as last weighted:
  // rows x y, with linear weights that sum to 1 over all particles.
  finished.particles(0, centers, weights);
  // About how many bytes a copy takes.
  { finished.memoryBytes() } -> std::same_as<std::size_t>;
};

/// The color image a filter needs and a box of at least 2 x 2 pixels that lies in it, at least
/// with its center: BadValue names "image" or "box".
Status checkBox(const cv::Mat& bgr, const ImageBox& box);

/// The box around the object that was clicked (see clickBox()): BadValue names "pixel" or "image".
Result<ImageBox> boxFromClick(const cv::Mat& bgr, double x, double y);

} // namespace dewpoint::tracking

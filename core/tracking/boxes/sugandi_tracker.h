// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/particle_set.h"
#include "core/observation/boxes/histogram_similarity.h"
#include "core/tracking/boxes/box_filter.h"

#include <optional>

namespace dewpoint::tracking {

/// The `sugandi` method: the color histogram particle filter of Sugandi, Kim, Tan and Ishikawa
/// (2009), exactly as published. The state is (x_k, y_k, x_k-1, y_k-1) in pixels. The box size and
/// the reference histogram are taken from the first image and never change.
class SugandiTracker final {
public:
  /// Creates a tracker. `parameters` must be declared by the `sugandi` method (asserted).
  explicit SugandiTracker(const ParameterValues& parameters);

  void configure(const ParameterValues& parameters);
  Status start(const cv::Mat& bgr, const ImageBox& box, std::uint64_t seed);
  BoxEstimate step(const cv::Mat& bgr, ThreadTeam& team);
  void copyParticles(int limit, Eigen::ArrayXXd& centers, Eigen::ArrayXd& weights) const;
  std::size_t memoryBytes() const;

private:
  void propagate(ThreadTeam& team);
  cv::Rect regionOfParticles(const cv::Size& image) const;
  void weigh(ThreadTeam& team);
  BoxEstimate estimateBox() const;
  void resample();

  double positionSigma_ = 0.0;
  double likelihoodSigma_ = 0.0;
  /// Number of particles for the next image; `states_` has the particles of the current image.
  Eigen::Index particleCount_ = 0;
  std::uint64_t seed_ = 0;
  std::uint32_t frame_ = 0;
  ImageBox box_; ///< initial box
  std::optional<HistogramSimilarity> similarity_;
  Eigen::ArrayXXd states_;   ///< rows of x_k, y_k, x_k-1, y_k-1
  Eigen::ArrayXXd weighted_; ///< states before resampling
  Eigen::ArrayXd weights_;   ///< weights of `weighted_`
  bool degenerate_ = false;
};

} // namespace dewpoint::tracking

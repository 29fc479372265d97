// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/particle_set.h"
#include "core/observation/boxes/target_colors.h"
#include "core/observation/boxes/target_map.h"
#include "core/tracking/boxes/box_filter.h"

#include <vector>

namespace dewpoint::tracking {

/// The `histogram` method, which implements and extends the future work listed by Sugandi et al.
/// (2009). See docs/method-sugandi.md. The state is (x, y, vx, vy, s, a) in pixels and pixels per
/// image; s is the logarithm of the scale, and a is the logarithm of the aspect ratio (width /
/// height). The color histograms of six parts of the box are compared with the histogram of the
/// surroundings. Some particles jump to other positions in the image that have the target's colors.
/// The histograms adapt to slow color changes. A hidden target keeps its position and is found
/// again.
class HistogramTracker final {
public:
  /// Creates a tracker. `parameters` must be declared by the `histogram` method (asserted).
  explicit HistogramTracker(const ParameterValues& parameters);

  void configure(const ParameterValues& parameters);
  Status start(const cv::Mat& bgr, const ImageBox& box, std::uint64_t seed);
  BoxEstimate step(const cv::Mat& bgr, ThreadTeam& team);
  void copyParticles(int limit, Eigen::ArrayXXd& centers, Eigen::ArrayXd& weights) const;
  std::size_t memoryBytes() const;

private:
  struct MotionDraws;

  cv::Mat shrunk(const cv::Mat& bgr) const;
  void fitSizeExponents();
  ImageBox drawnBoxAround(const ImageBox& figure) const;
  double size() const;
  double reach() const;
  cv::Rect searchRegion() const;
  ImageBox boxOf(const Eigen::ArrayXXd& states, Eigen::Index row) const;
  double sizeFactor(const ImageBox& box) const;
  double score(const ImageBox& box) const;
  void jump(Eigen::Index row, const std::vector<Eigen::Vector2d>& peaks, const MotionDraws& draws,
            double& logWeight);
  void predictWithConstantVelocity(Eigen::Index row, const MotionDraws& draws);
  void move(const std::vector<Eigen::Vector2d>& peaks, Eigen::ArrayXd& logWeights,
            ThreadTeam& team);
  BoxEstimate estimateMode(const cv::Mat& bgr);
  void adapt(const cv::Mat& bgr, double share);
  void resample();

  double positionSigma_ = 0.0;
  double scaleSigma_ = 0.0;
  double aspectSigma_ = 0.0;
  double jumpShare_ = 0.0;
  double jumpReach_ = 0.0;
  double sharpness_ = 0.0;
  double adaptation_ = 0.0;
  double hiddenBelow_ = 0.0;
  /// Number of particles for the next image; `states_` has the particles of the current image.
  Eigen::Index particleCount_ = 0;
  std::uint64_t seed_ = 0;
  std::uint32_t frame_ = 0;
  double shrink_ = 1.0; ///< images are scaled by this factor before processing
  /// Initial box in the scaled image; all following boxes are also in the scaled image.
  ImageBox drawn_;
  /// Box around the object in the initial box, see boxWithoutMargin(); it is the box that is
  /// tracked.
  ImageBox first_;
  ImageBox box_; ///< last box in which the target was visible
  int hiddenFrames_ = 0;
  double widthExponent_ = 0.0; ///< see fitSizeExponents()
  double heightExponent_ = 0.0;
  double usualScore_ = 1.0;
  double firstLikeness_ = 1.0; ///< value for the first image, see TargetColors::similarityOf()
  TargetColors colors_;
  TargetMap map_;
  Eigen::ArrayXXd states_;   ///< rows of x, y, vx, vy, s, a
  Eigen::ArrayXXd weighted_; ///< states before resampling
  Eigen::ArrayXd weights_;   ///< weights of `weighted_`
  bool degenerate_ = false;
};

} // namespace dewpoint::tracking

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/background_suppression.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// The background of one camera: a running mean color per pixel, learned while the camera records.
/// It tells "the background is seen here" from "something new is here". A new object that stays
/// becomes background after a while, so that the model recovers from a moved camera or a switched
/// lamp.
class BackgroundModel {
public:
  /// A circle in the image, in pixels, inside which nothing is learned: a target is there.
  struct Hidden {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0.0;
  };

  /// Agreeing observations that make a pixel known. A judgment: 12 frames, since a frame updates
  /// every fourth row; fewer would take a passing object for a wall.
  static constexpr int kLearned = 3;
  /// A color agrees with the mean within this many gray levels (five standard deviations of usual
  /// sensor noise) and an eighth of the mean (light that changes a little).
  static constexpr int kTolerance = kFamiliarLevels;
  static constexpr int kToleranceShift = kFamiliarShift;

  BackgroundModel() = default;
  /// A copy has pixels of its own.
  BackgroundModel(const BackgroundModel& other);
  BackgroundModel(BackgroundModel&&) = default;
  BackgroundModel& operator=(BackgroundModel other) noexcept;
  ~BackgroundModel() = default;

  /// The image without targets (CV_8UC3; empty: not known). It is learned at the next reset(). A
  /// pixel that matches a target's color but did so in this image is explained by it, until
  /// something new stays there.
  void setEmptyRoom(const cv::Mat& image) { emptyRoom_ = image.clone(); }
  /// Forgets everything but the empty room.
  void reset();
  /// Adapts the means to the light of an image, where the whole image has become brighter, darker
  /// or of another tint at once (estimateLightChange()). Before the labels of the image are made.
  void followLight(const cv::Mat& image);
  /// Learns from every fourth row of an image (CV_8UC3), other rows each time. An image of another
  /// size starts from scratch. With `noTargetElsewhere` no target is outside of `hidden`, so that
  /// what has a target's color there is none: after some observations it counts as what the empty
  /// room showed.
  void learn(const cv::Mat& image, const std::vector<Hidden>& hidden,
             bool noTargetElsewhere = false);
  /// What learn() with `noTargetElsewhere` has found out is no longer believed: everywhere, or
  /// inside a circle, where a target was after all.
  void forgetEmptyPlaces();
  void forgetEmptyPlaces(const Hidden& circle);
  /// Bytes of its images.
  std::size_t memoryBytes() const;
  /// Share of the known pixels among those last learned from that showed something new, 0 to 1:
  /// near 1 when the camera is covered, blind or moved.
  double novelShare() const { return novelShare_; }

  /// The light of the last image per channel (blue, green, red), as a factor of the reference
  /// light: that of the first image, or of the last call of resetReferenceLight().
  const Eigen::Array3d& light() const { return light_; }
  void resetReferenceLight() { light_.setOnes(); }

  /// The value of `matched` in labelRow() for a pixel that has the target's color only after
  /// conversion to the reference light: it is the target's unless it agrees with the background.
  static constexpr std::uint8_t kInUsualLight = 1;
  /// Makes the labels (PixelLabel) of `count` pixels of one row, from `column` on: Target where
  /// `matched` is 255, unless the empty room is known to show the same there (Explained);
  /// else Unlearned, Background or Unknown.
  void labelRow(const cv::Mat& image, int column, int row, int count, const std::uint8_t* matched,
                std::uint8_t* labels) const;

private:
  void learnRow(const cv::Mat& image, int row, const std::vector<Hidden>& hidden,
                bool noTargetElsewhere);
  void start(const cv::Mat& image);
  void learnPixels(const cv::Mat& image, int row, int begin, int end, bool noTargetElsewhere);

  cv::Mat mean_;       ///< CV_8UC3
  cv::Mat confidence_; ///< CV_8UC1, observations that agreed, up to kMostConfident
  cv::Mat novel_;      ///< CV_8UC1, observations in a row that did not
  cv::Mat emptyRoom_;  ///< CV_8UC3, never written to
  /// CV_8UC1, or empty: 255 where the mean is still that of the empty room; else the observations
  /// without a target, from kEmptyAfter on as good as the empty room.
  cv::Mat familiar_;
  bool lightIsNew_ = false;         ///< no image was seen since the empty room, of unknown light
  int phase_ = 0;                   ///< first row of the next learn()
  std::int64_t known_ = 0;          ///< pixels of the last learn() that were known
  std::int64_t new_ = 0;            ///< of these, pixels that showed something new
  std::vector<std::uint8_t> moves_; ///< scratch, one row
  std::vector<std::uint8_t> news_;  ///< scratch, one row
  double novelShare_ = 0.0;
  Eigen::Array3d light_ = Eigen::Array3d::Ones();
};

} // namespace dewpoint::observation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/background_suppression.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// Background of one camera: a running mean color per pixel, learned during the recording. It
/// distinguishes pixels that show the background from pixels that show something new. A new object
/// that stays becomes background after a while, so the model recovers when the camera is moved or a
/// lamp is switched.
class BackgroundModel {
public:
  /// Circle in the image, in pixels, in which nothing is learned because a target is there.
  struct Hidden {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0.0;
  };

  /// Number of agreeing observations after which a pixel is known. A judgment: 12 frames, because
  /// each frame updates every fourth row. With fewer, a passing object would be taken for
  /// background.
  static constexpr int kLearned = 3;
  /// Tolerance in gray levels (five standard deviations of usual sensor noise). A color agrees with
  /// the mean if the difference is within this plus one eighth of the mean, which allows for small
  /// changes of light.
  static constexpr int kTolerance = kFamiliarLevels;
  static constexpr int kToleranceShift = kFamiliarShift;

  BackgroundModel() = default;
  /// Copies the pixels too.
  BackgroundModel(const BackgroundModel& other);
  BackgroundModel(BackgroundModel&&) = default;
  BackgroundModel& operator=(BackgroundModel other) noexcept;
  ~BackgroundModel() = default;

  /// The image without targets (CV_8UC3; empty: not known). It is learned at the next reset(). A
  /// pixel that matches a target's color but did so in this image is explained by it, until
  /// something new stays there.
  void setBackgroundImage(const cv::Mat& image) { backgroundImage_ = image.clone(); }
  /// Forgets everything but the background image.
  void reset();
  /// Adapts the means to the light of an image if the whole image has become brighter, darker or
  /// differently tinted at once (estimateLightChange()). Call it before the labels of the image are
  /// computed.
  void followLight(const cv::Mat& image);
  /// Learns from every fourth row of an image (CV_8UC3), starting at a different row each time. An
  /// image of another size restarts the model. If `noTargetElsewhere` is set, no target is outside
  /// `hidden`. A pixel that has a target's color there is therefore not a target; after some
  /// observations it counts as if the background image had shown it.
  void learn(const cv::Mat& image, const std::vector<Hidden>& hidden,
             bool noTargetElsewhere = false);
  /// What learn() with `noTargetElsewhere` has found out is no longer believed: everywhere, or
  /// inside a circle, where a target was after all.
  void forgetFamiliarPixels();
  void forgetFamiliarPixels(const Hidden& circle);
  /// Bytes of its images.
  std::size_t memoryBytes() const;
  /// Share of the known pixels in the last learn() that showed something new, 0 to 1. Near 1 when
  /// the camera is covered, blind or moved.
  double novelShare() const { return novelShare_; }

  /// Light of the last image per channel (blue, green, red), as a factor of the reference light.
  /// The reference is the light of the first image, or of the last call of resetReferenceLight().
  const Eigen::Array3d& light() const { return light_; }
  void resetReferenceLight() { light_.setOnes(); }

  /// Value of `matched` in labelRow() for a pixel that has the target's color only after conversion
  /// to the reference light. It belongs to the target unless it agrees with the background.
  static constexpr std::uint8_t kInUsualLight = 1;
  /// Makes the labels (PixelLabel) of `count` pixels of one row, from `column` on: Target where
  /// `matched` is 255, unless the background image is known to show the same there (Explained);
  /// else Unlearned, Background or Unknown.
  void labelRow(const cv::Mat& image, int column, int row, int count, const std::uint8_t* matched,
                std::uint8_t* labels) const;

private:
  void learnRow(const cv::Mat& image, int row, const std::vector<Hidden>& hidden,
                bool noTargetElsewhere);
  void start(const cv::Mat& image);
  void learnPixels(const cv::Mat& image, int row, int begin, int end, bool noTargetElsewhere);

  cv::Mat mean_;            ///< CV_8UC3
  cv::Mat confidence_;      ///< CV_8UC1, observations that agreed, up to kMostConfident
  cv::Mat novel_;           ///< CV_8UC1, observations in a row that did not
  cv::Mat backgroundImage_; ///< CV_8UC3, never written to
  /// CV_8UC1, or empty: 255 where the mean is still that of the background image; else the
  /// observations without a target, from kEmptyAfter on as good as the background image.
  cv::Mat familiar_;
  bool lightIsNew_ = false; ///< no image was seen since the background image, of unknown light
  int phase_ = 0;           ///< first row of the next learn()
  std::int64_t known_ = 0;  ///< pixels of the last learn() that were known
  std::int64_t new_ = 0;    ///< of these, pixels that showed something new
  std::vector<std::uint8_t> moves_; ///< scratch, one row
  std::vector<std::uint8_t> news_;  ///< scratch, one row
  double novelShare_ = 0.0;
  Eigen::Array3d light_ = Eigen::Array3d::Ones();
};

} // namespace dewpoint::observation

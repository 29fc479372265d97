// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/background_suppression.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// What one camera usually shows: a running mean color per pixel, learned while the camera looks.
/// It tells "the wall is seen here" from "something new is here". A new thing that stays becomes
/// background after a while, so that a moved camera or a switched lamp heals.
class BackgroundModel {
public:
  /// A circle in the image, in pixels, that is not to be learned: a target is there.
  struct Hidden {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0.0;
  };

  /// Agreeing observations that make a pixel known.
  static constexpr int kLearned = 3;
  /// A color is the usual one within this many gray levels (sensor noise) and an eighth of the mean
  /// (light that changes a little).
  static constexpr int kTolerance = kFamiliarLevels;
  static constexpr int kToleranceShift = kFamiliarShift;

  BackgroundModel() = default;
  /// A copy has pixels of its own.
  BackgroundModel(const BackgroundModel& other);
  BackgroundModel(BackgroundModel&&) = default;
  BackgroundModel& operator=(BackgroundModel other) noexcept;
  ~BackgroundModel() = default;

  /// What the camera shows when no target is there (CV_8UC3; empty: not known), known from the next
  /// reset() on. What matches a target's color but did so in the empty room is explained then,
  /// until something new stays there.
  void setEmptyRoom(const cv::Mat& room) { emptyRoom_ = room.clone(); }
  /// Forgets everything but the empty room.
  void reset();
  /// Before the labels of a new image are made: where the whole image has become brighter, darker
  /// or of another tint at once, what is usually there is what it was in this light. Does nothing
  /// when no such change explains most of the image (something covers it, it is black, it moved).
  void followLight(const cv::Mat& image);
  /// Learns from an image (CV_8UC3), a quarter of its rows at a time. A new size starts anew.
  void learn(const cv::Mat& image, const std::vector<Hidden>& hidden);
  /// Bytes of its images.
  std::size_t memoryBytes() const;
  /// Share of the rows last learned from that showed something new, 0 to 1: near 1 when the camera
  /// is covered, blind or moved.
  double novelShare() const { return novelShare_; }

  /// The light of now per channel (BGR), where 1 is that of the first image or of the last call of
  /// takeLightAsUsual().
  const Eigen::Array3d& light() const { return light_; }
  void takeLightAsUsual() { light_.setOnes(); }

  /// What labelRow() is told of a pixel that has the target's color only when the light of now is
  /// taken into account: it is the target's unless it shows what is usually there.
  static constexpr std::uint8_t kInUsualLight = 1;
  /// Labels (core/observation/background/label_image.h) of `count` pixels of one row, from `column`
  /// on: Target where `matched` is 255, unless the empty room is known to show the same there
  /// (Explained); else Unlearned, Background or Unknown.
  void labelRow(const cv::Mat& image, int column, int row, int count, const std::uint8_t* matched,
                std::uint8_t* labels) const;

private:
  struct LightSample;
  std::vector<LightSample> lightSamples(const cv::Mat& image) const;
  void learnRow(const cv::Mat& image, int row, const std::vector<Hidden>& hidden);
  void start(const cv::Mat& image);
  void followGain(const cv::Mat& image);
  void learnPixels(const cv::Mat& image, int row, int begin, int end);

  cv::Mat mean_;       ///< CV_8UC3
  cv::Mat confidence_; ///< CV_8UC1, observations that agreed, up to kMostConfident
  cv::Mat novel_;      ///< CV_8UC1, observations in a row that did not
  cv::Mat emptyRoom_;  ///< CV_8UC3, never written to
  cv::Mat familiar_;   ///< CV_8UC1, 255 where the mean is still that of the empty room; or empty
  bool lightIsNew_ = false; ///< the room was empty in another light, perhaps
  int phase_ = 0;
  std::int64_t known_ = 0;
  std::int64_t new_ = 0;
  std::vector<std::uint8_t> moves_; ///< scratch, one row
  std::vector<std::uint8_t> news_;  ///< scratch, one row
  double novelShare_ = 0.0;
  Eigen::Array3d light_ = Eigen::Array3d::Ones(); ///< of now, where 1 is that of the first image
};

} // namespace dewpoint::observation

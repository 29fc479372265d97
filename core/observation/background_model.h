// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint {

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

  /// Forgets everything.
  void reset();
  /// Learns from an image (CV_8UC3), a quarter of its rows at a time. A new size starts anew.
  void learn(const cv::Mat& image, const std::vector<Hidden>& hidden);
  /// Share of the rows last learned from that showed something new, 0 to 1: near 1 when the camera
  /// is covered, blind or moved.
  double novelShare() const { return novelShare_; }

  /// Labels (core/observation/label_image.h) of `count` pixels of one row, from `column` on: Target
  /// where `matched` is not 0, else Unlearned, Background or Unknown.
  void labelRow(const cv::Mat& image, int column, int row, int count, const std::uint8_t* matched,
                std::uint8_t* labels) const;

private:
  void learnRow(const cv::Mat& image, int row, const std::vector<Hidden>& hidden);
  void learnPixels(const cv::Mat& image, int row, int begin, int end);

  cv::Mat mean_;       ///< CV_8UC3
  cv::Mat confidence_; ///< CV_8UC1, observations that agreed, up to kMostConfident
  cv::Mat novel_;      ///< CV_8UC1, observations in a row that did not
  int phase_ = 0;
  std::int64_t known_ = 0;
  std::int64_t new_ = 0;
  std::vector<std::uint8_t> moves_; ///< scratch, one row
  std::vector<std::uint8_t> news_;  ///< scratch, one row
  double novelShare_ = 0.0;
};

} // namespace dewpoint

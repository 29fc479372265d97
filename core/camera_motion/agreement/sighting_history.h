// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/color_regions.h"
#include "core/geometry/camera.h"
#include "core/geometry/ray.h"

#include <Eigen/Core>

#include <deque>
#include <vector>

namespace dewpoint::camera_motion {

/// A region of a target's color as one camera saw it, followed from image to image.
struct RegionSighting {
  ColorRegion region;
  Eigen::Vector2d rate = Eigen::Vector2d::Zero(); ///< of the center, pixels per second
  /// Of the center: unit vector in camera axes, and how it changes per second.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d directionRate = Eigen::Vector3d::Zero();
  int track = 0; ///< of the same region in other images
  /// It has moved by its own radius since the one of its track that counted before. Regions at rest
  /// never count, and what is wrong with one that hardly moves counts once.
  bool counts = false;
};

/// All of one image.
struct SightingImage {
  double time = 0.0; ///< seconds
  std::vector<RegionSighting> regions;
};

/// The regions of one color in the images of one camera over the last seconds.
class SightingHistory {
public:
  /// Seconds that are kept.
  static constexpr double kKept = 4.0;

  SightingHistory(const ColorRanges& color, const Camera& camera);

  /// Searches the next image (CV_8UC3), taken at `time` (seconds). An image that is not later than
  /// the last one is passed over.
  void add(const cv::Mat& image, double time);
  void clear() { images_.clear(); }
  /// How many of the regions count.
  std::size_t counted() const;
  /// In the order of time.
  const std::deque<SightingImage>& images() const { return images_; }

private:
  /// Where a track counted last, or began.
  struct Counted {
    int track;
    Eigen::Vector2d center;
  };
  void follow(const SightingImage& before, SightingImage& now);

  ColorRegionSearch search_;
  Unprojector unprojector_; ///< to camera axes
  std::deque<SightingImage> images_;
  std::vector<Counted> counted_; ///< of the tracks of the last image
  int tracks_ = 0;
};

} // namespace dewpoint::camera_motion

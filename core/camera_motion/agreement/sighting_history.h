// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/color_regions.h"
#include "core/geometry/camera.h"
#include "core/geometry/ray.h"

#include <Eigen/Core>

#include <deque>
#include <vector>

namespace dewpoint::camera_motion {

/// Region in a target's color as seen by one camera, tracked from image to image.
struct RegionSighting {
  ColorRegion region;
  Eigen::Vector2d rate = Eigen::Vector2d::Zero(); ///< velocity of the center, pixels per second
  /// Direction to the center (unit vector in camera axes), and its rate of change per second.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d directionRate = Eigen::Vector3d::Zero();
  int track = 0; ///< track number, which is the same in all images in which this region is tracked
  /// True if this sighting may be used as evidence. The region must have moved by at least its own
  /// radius since the last sighting of this track that counted, or since the track began. A region
  /// at rest therefore never counts, and a region that moves slowly does not count in every image.
  bool countsAsEvidence = false;
};

/// All sightings of one color in one image.
struct SightingImage {
  double captureTime = 0.0; ///< capture time of the image, seconds
  std::vector<RegionSighting> regions;
};

/// Regions of one color in the images of one camera over the last few seconds.
class SightingHistory {
public:
  /// Time span for which images are kept, in seconds.
  static constexpr double kHistorySeconds = 4.0;

  SightingHistory(const ColorRanges& color, const Camera& camera);

  /// Finds the regions in the next image (CV_8UC3), taken at `time` (seconds), and continues their
  /// tracks. An image that is not later than the previous image is ignored.
  void add(const cv::Mat& image, double time);
  void clear() { images_.clear(); }
  /// Returns the number of sightings that count as evidence (RegionSighting::countsAsEvidence).
  std::size_t countEvidence() const;
  /// Returns the sightings of each image, in order of time.
  const std::deque<SightingImage>& images() const { return images_; }

private:
  /// Position of a region in the last sighting of its track that counted as evidence, or when the
  /// track began.
  struct CountedPosition {
    int track;
    Eigen::Vector2d center;
  };
  void trackRegions(const SightingImage& before, SightingImage& now);

  ColorRegionSearch search_;
  Unprojector unprojector_; ///< converts pixels to directions in camera axes
  std::deque<SightingImage> images_;
  std::vector<CountedPosition> counted_; ///< one position for each track in the last image
  int tracks_ = 0;
};

} // namespace dewpoint::camera_motion

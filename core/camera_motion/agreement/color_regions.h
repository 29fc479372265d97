// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::camera_motion {

/// Connected region of pixels in a target's color. All lengths are in pixels; pixel centers are at
/// integer coordinates.
struct ColorRegion {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0; ///< radius of the disk with the same area
  /// Uncertainty of `center` as an estimate of the center of the object's full outline: standard
  /// deviation per axis. The uncertainty is small for a round region, and about as large as the
  /// radius for a region that is cut off or not round.
  double sigma = 0.0;
  /// Part of `sigma` that results from the shape of the region and stays constant while the object
  /// moves.
  double biasSigma = 0.0;
};

/// Finds the regions of one color in images. Only every few rows are scanned. This is enough to
/// show where objects are and how they move, in a small fraction of the time that labeling each
/// pixel takes.
class ColorRegionSearch {
public:
  /// Maximum number of regions reported per image; the largest regions are kept.
  static constexpr std::size_t kMaxRegions = 8;

  explicit ColorRegionSearch(const ColorRanges& color) : classifier_(color) {}

  /// Returns the regions in an image (CV_8UC3), largest first. Returns no regions for other image
  /// types, or if the color occurs at hundreds of positions. Regions that are separated by a gap
  /// smaller than their size count as one region. A ball with a highlight or a pattern is therefore
  /// one region.
  const std::vector<ColorRegion>& find(const cv::Mat& image);

private:
  /// Sums over the pixels of a region.
  struct Sums {
    double area = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
    int left = 0, right = 0, top = 0, bottom = 0;

    void add(const Sums& other);
    Eigen::Vector2d center() const { return {x / area, y / area}; }
    double radius() const;
  };
  struct Run {
    int left, right; ///< first and last column of a run of pixels in the color
    std::size_t part;
  };
  std::size_t rootOf(std::size_t part);
  void scanRow(const cv::Mat& image, int row, int step);
  void mergeNearRegions();
  ColorRegion regionOf(const Sums& sums, const cv::Mat& image, int step) const;

  ColorClassifier classifier_;
  // Reused for every image, so that no memory is allocated.
  std::vector<std::uint8_t> match_;
  std::vector<Run> above_, here_;
  std::vector<std::size_t> parents_;
  std::vector<Sums> sums_;
  std::vector<ColorRegion> regions_;
};

} // namespace dewpoint::camera_motion

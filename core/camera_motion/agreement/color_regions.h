// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::camera_motion {

/// Pixels of a target's color that lie together. Pixels, centers at integer coordinates.
struct ColorRegion {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0; ///< of the disc of the same area
  /// How far the center may be from that of the object's whole outline, one standard deviation per
  /// axis: little for a round region, about the radius for one that is cut or of any other shape.
  double sigma = 0.0;
  /// The part of it that comes from the shape, and stays the same while the object moves.
  double bias = 0.0;
};

/// Finds the regions of one color in images, on every few rows: for where things are and how they
/// move, at a small part of what a label of each pixel costs.
class ColorRegionSearch {
public:
  /// The largest regions that are reported of an image.
  static constexpr std::size_t kMost = 8;

  explicit ColorRegionSearch(const ColorRanges& color) : classifier_(color) {}

  /// The regions of an image (CV_8UC3), the largest first; none for another type, or where the
  /// color is found in hundreds of places. What is apart by less than its size counts as one: a
  /// ball with a highlight, or with a pattern on it.
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
    int left, right; ///< columns, both included
    std::size_t part;
  };
  std::size_t rootOf(std::size_t part);
  void scanRow(const cv::Mat& image, int row, int step);
  void joinNear();
  ColorRegion regionOf(const Sums& sums, const cv::Mat& image, int step) const;

  ColorClassifier classifier_;
  // Kept from image to image, so that no memory is allocated.
  std::vector<std::uint8_t> match_;
  std::vector<Run> above_, here_;
  std::vector<std::size_t> parents_;
  std::vector<Sums> sums_;
  std::vector<ColorRegion> regions_;
};

} // namespace dewpoint::camera_motion

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A predefined dictionary of ArUco markers. Works with both ArUco interfaces of OpenCV: the one
/// before version 4.7 and the one since.
class MarkerDictionary {
public:
  /// Creates the dictionary with the OpenCV name `name`, one of markerDictionaries().
  explicit MarkerDictionary(const std::string& name);
  ~MarkerDictionary();
  MarkerDictionary(MarkerDictionary&&) noexcept;
  MarkerDictionary& operator=(MarkerDictionary&&) noexcept;

  /// Returns the number of markers in the dictionary. Their ids count from 0.
  int size() const;
  /// Returns the number of cells in a row of a marker, without its black border.
  int cellsPerRow() const;
  /// Returns the cells of a marker without its border: CV_8UC1, 0 for black and 1 for white.
  cv::Mat cellsOf(int id) const;

  /// Markers that detect() found in an image.
  struct Detections {
    /// Four corners of each marker in pixels, clockwise from the marker's own upper left corner.
    std::vector<std::vector<cv::Point2f>> outlines;
    std::vector<int> ids; ///< id of the marker in each outline
    /// Outlines of quadrilaterals that look like markers but do not belong to this dictionary,
    /// pixels.
    std::vector<std::vector<cv::Point2f>> otherOutlines;
  };
  /// Returns the markers in a gray image (CV_8UC1), in any order. If two outlines are closer to
  /// each other than `minDistanceRate` times their perimeter, only one of them is returned. If
  /// `minDistanceRate` is empty, OpenCV's default is used.
  Detections detect(const cv::Mat& gray, std::optional<double> minDistanceRate = {}) const;

private:
  struct Data;
  std::unique_ptr<Data> data_;
};

} // namespace dewpoint::calibration

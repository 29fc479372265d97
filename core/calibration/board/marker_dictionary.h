// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A predefined dictionary of ArUco markers. Hides the differences between the ArUco modules of
/// OpenCV: until 4.6 it is in opencv_contrib, from 4.7 on in objdetect with another interface.
class MarkerDictionary {
public:
  /// `name` is one of markerDictionaries().
  explicit MarkerDictionary(const std::string& name);
  ~MarkerDictionary();
  MarkerDictionary(MarkerDictionary&&) noexcept;
  MarkerDictionary& operator=(MarkerDictionary&&) noexcept;

  /// Number of markers; their ids count from 0.
  int size() const;
  /// Number of cells in a row of a marker, without its black border.
  int cells() const;
  /// Returns the cells of a marker without its border: CV_8UC1, 0 for black and 1 for white.
  cv::Mat cellsOf(int id) const;

  /// Markers in an image.
  struct Detections {
    std::vector<std::vector<cv::Point2f>> outlines; ///< four corners of each marker, in pixels,
                                                    ///< clockwise from the first one of the marker
    std::vector<int> ids;                           ///< of each outline
    /// Quadrilaterals that may be markers, but not of this dictionary.
    std::vector<std::vector<cv::Point2f>> otherOutlines;
  };
  /// Detects the markers in a gray image (CV_8UC1), in any order. Of two outlines that are closer
  /// than `minDistanceRate` times their perimeter, only one counts; if not given, OpenCV's default
  /// holds.
  Detections detect(const cv::Mat& gray, std::optional<double> minDistanceRate = {}) const;

private:
  struct Data;
  std::unique_ptr<Data> data_;
};

} // namespace dewpoint::calibration

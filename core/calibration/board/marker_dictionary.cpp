// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/marker_dictionary.h"

#include "core/calibration/board/board.h"

#include <opencv2/core/version.hpp>

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
#include <opencv2/objdetect/aruco_detector.hpp>
#define DEWPOINT_NEW_ARUCO 1
#else
#include <opencv2/aruco.hpp>
#define DEWPOINT_NEW_ARUCO 0
#endif

#include <algorithm>

namespace dewpoint::calibration {

struct MarkerDictionary::Data {
  cv::aruco::Dictionary dictionary;
};

MarkerDictionary::MarkerDictionary(const std::string& name) : data_(std::make_unique<Data>()) {
  const auto& names = markerDictionaries();
  const auto number = std::ranges::find(names, name) - names.begin();
#if DEWPOINT_NEW_ARUCO
  data_->dictionary =
      cv::aruco::getPredefinedDictionary(static_cast<cv::aruco::PredefinedDictionaryType>(number));
#else
  data_->dictionary = *cv::aruco::getPredefinedDictionary(
      static_cast<cv::aruco::PREDEFINED_DICTIONARY_NAME>(number));
#endif
}

MarkerDictionary::~MarkerDictionary() = default;
MarkerDictionary::MarkerDictionary(MarkerDictionary&&) noexcept = default;
MarkerDictionary& MarkerDictionary::operator=(MarkerDictionary&&) noexcept = default;

int MarkerDictionary::size() const {
  return data_->dictionary.bytesList.rows;
}

int MarkerDictionary::cellsPerRow() const {
  return data_->dictionary.markerSize;
}

cv::Mat MarkerDictionary::cellsOf(int id) const {
  return cv::aruco::Dictionary::getBitsFromByteList(
      data_->dictionary.bytesList.rowRange(id, id + 1), cellsPerRow());
}

MarkerDictionary::Detections MarkerDictionary::detect(const cv::Mat& gray,
                                                      std::optional<double> minDistanceRate) const {
  Detections found;
#if DEWPOINT_NEW_ARUCO
  cv::aruco::DetectorParameters parameters;
  parameters.minMarkerDistanceRate = minDistanceRate.value_or(parameters.minMarkerDistanceRate);
  cv::aruco::ArucoDetector(data_->dictionary, parameters)
      .detectMarkers(gray, found.outlines, found.ids, found.otherOutlines);
#else
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->minMarkerDistanceRate = minDistanceRate.value_or(parameters->minMarkerDistanceRate);
  cv::aruco::detectMarkers(gray, cv::makePtr<cv::aruco::Dictionary>(data_->dictionary),
                           found.outlines, found.ids, parameters, found.otherOutlines);
#endif
  return found;
}

} // namespace dewpoint::calibration

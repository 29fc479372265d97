// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/people_exposure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dewpoint::simulation {
namespace {

/// Seconds, chosen: somebody at 1 m/s, 4 m away from one of the office's cameras, moves by one
/// pixel.
constexpr double kExposureStep = 1.0 / 60.0;

} // namespace

std::vector<ExposureStep> exposureSteps(const Shutter& shutter, int rows) {
  const double exposure = shutter.exposureSeconds;
  const double span = exposure + shutter.readoutSeconds;
  if (exposure <= 0.0) {
    return {{0.0, std::vector<float>(static_cast<std::size_t>(rows), 1.0F)}};
  }
  const int count = std::max(1, static_cast<int>(std::ceil(span / kExposureStep)));
  const double length = span / count;
  std::vector<ExposureStep> steps;
  steps.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double begin = -0.5 * span + k * length;
    ExposureStep& step = steps.emplace_back();
    step.centerTime = begin + 0.5 * length;
    step.rowShares.reserve(static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row) {
      const double middle = rowTime(shutter, row, rows);
      const double open = std::min(begin + length, middle + 0.5 * exposure) -
                          std::max(begin, middle - 0.5 * exposure);
      step.rowShares.push_back(static_cast<float>(std::max(0.0, open) / exposure));
    }
  }
  return steps;
}

void paintPeopleThroughShutter(const RoomView& view, const PeopleAt& people,
                               const PeopleLight& light, const Shutter& shutter, cv::Mat& image) {
  cv::Mat sum = cv::Mat::zeros(image.size(), CV_32FC3);
  for (const ExposureStep& step : exposureSteps(shutter, image.rows)) {
    cv::Mat now = image.clone();
    paintPeople(view, people(light.lightField.time + step.centerTime), light, now);
    for (int row = 0; row < image.rows; ++row) {
      if (const float share = step.rowShares[static_cast<std::size_t>(row)]; share > 0.0F) {
        sum.row(row) += share * now.row(row);
      }
    }
  }
  image = sum;
}

} // namespace dewpoint::simulation

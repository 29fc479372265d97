// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/color_peaks.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

constexpr double kGrid = 0.25;
constexpr double kApart = 0.75; // of width or height

struct Place {
  double sum = 0.0;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
};

} // namespace

std::vector<Eigen::Vector2d> findColorPeaks(const TargetMap& map, double width, double height,
                                            std::size_t most, double least) {
  const double step = std::max(1.0, std::floor(kGrid * std::min(width, height)));
  const cv::Rect& region = map.region();
  std::vector<Place> places;
  for (double y = region.y; y <= region.y + region.height; y += step) {
    for (double x = region.x; x <= region.x + region.width; x += step) {
      const Eigen::Vector2d center(x, y);
      const double sum = map.sum(ImageBox::around(center, width, height));
      if (sum >= least) {
        places.push_back({sum, center});
      }
    }
  }
  std::ranges::stable_sort(places, std::greater<>(), &Place::sum);
  std::vector<Eigen::Vector2d> peaks;
  for (const Place& place : places) {
    const bool apart = std::ranges::all_of(peaks, [&](const Eigen::Vector2d& peak) {
      const Eigen::Vector2d away = (place.center - peak).cwiseAbs();
      return away.x() >= kApart * width || away.y() >= kApart * height;
    });
    if (apart) {
      peaks.push_back(place.center);
    }
    if (peaks.size() == most) {
      break;
    }
  }
  return peaks;
}

} // namespace dewpoint::tracking

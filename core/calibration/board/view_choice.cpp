// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/view_choice.h"

#include "core/calibration/board/intrinsics_from_board.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr double kSoftFactor = 1.6; // times the edges of the sharp views: motion or focus
/// Of a difference in tilt against one in position and size.
constexpr double kTiltWeight = 0.7;
constexpr double kSeenByOneOnly = 0.3; // how different two instants are to a camera that saw one

/// `count` of `size` things, each as far as possible from those chosen before; sorted. `first` is
/// where to begin.
std::vector<std::size_t> farApart(std::size_t size, std::size_t count, std::size_t first,
                                  const std::function<double(std::size_t, std::size_t)>& distance) {
  std::vector<std::size_t> chosen{first};
  std::vector<double> nearest(size, std::numeric_limits<double>::max());
  while (chosen.size() < count) {
    for (std::size_t k = 0; k < size; ++k) {
      nearest[k] = std::min(nearest[k], distance(k, chosen.back()));
    }
    chosen.push_back(static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin()));
  }
  std::ranges::sort(chosen);
  return chosen;
}

/// Drops the views whose edges are soft beside those of the sharpest fifth.
std::vector<BoardView> sharp(std::vector<BoardView> views) {
  std::vector<double> widths;
  widths.reserve(views.size());
  for (const BoardView& view : views) {
    widths.push_back(view.detection.edgeWidthPx);
  }
  std::ranges::sort(widths);
  const double limit = widths.empty() ? 0.0 : kSoftFactor * widths[widths.size() / 5];
  std::erase_if(views, [&](const BoardView& view) { return view.detection.edgeWidthPx > limit; });
  return views;
}

/// Place, size and tilt of a board in an image, so that 1 is a large difference.
Eigen::Matrix<double, 5, 1> featureOf(const BoardDescription& board,
                                      const BoardDetection& detection, const Camera& camera) {
  Eigen::Matrix<double, 5, 1> feature = Eigen::Matrix<double, 5, 1>::Zero();
  if (const auto pose = boardPose(board, detection, camera)) {
    const Eigen::Vector3d middle = *pose * board.center();
    const double reach = 0.5 * camera.intrinsics.width / camera.intrinsics.focalX;
    feature << middle.x() / middle.z() / reach, middle.y() / middle.z() / reach,
        std::log(middle.z()), pose->linear()(0, 2), pose->linear()(1, 2);
    feature.tail<2>() *= 1.0 / kTiltWeight;
  }
  return feature;
}

} // namespace

std::vector<BoardView> chooseViews(const BoardDescription& board, std::vector<BoardView> views,
                                   int width, int height, int count) {
  if (views.size() <= static_cast<std::size_t>(count)) {
    return views;
  }
  if (auto clear = sharp(views); clear.size() >= static_cast<std::size_t>(count)) {
    views = std::move(clear);
  }
  const Camera camera = guessedCamera(width, height);
  std::vector<Eigen::Matrix<double, 5, 1>> features;
  std::size_t sharpest = 0;
  for (std::size_t k = 0; k < views.size(); ++k) {
    features.push_back(featureOf(board, views[k].detection, camera));
    if (views[k].detection.edgeWidthPx < views[sharpest].detection.edgeWidthPx) {
      sharpest = k;
    }
  }
  std::vector<BoardView> chosen;
  for (const std::size_t k : farApart(views.size(), static_cast<std::size_t>(count), sharpest,
                                      [&](std::size_t one, std::size_t other) {
                                        return (features[one] - features[other]).norm();
                                      })) {
    chosen.push_back(views[k]);
  }
  return chosen;
}

std::vector<std::vector<BoardView>> chooseInstants(const std::vector<std::vector<BoardView>>& views,
                                                   const std::vector<int>& widths, int count,
                                                   std::optional<std::int64_t> always) {
  std::map<std::int64_t, std::vector<const BoardView*>> byInstant;
  std::vector<std::vector<BoardView>> clear;
  clear.reserve(views.size());
  for (const auto& camera : views) {
    clear.push_back(sharp(camera));
  }
  for (std::size_t camera = 0; camera < views.size(); ++camera) {
    for (const BoardView& view : clear[camera]) {
      auto& instant = byInstant[view.instant];
      instant.resize(views.size());
      instant[camera] = &view;
    }
  }
  std::vector<std::int64_t> shared;
  for (const auto& [instant, seen] : byInstant) {
    if (views.size() - static_cast<std::size_t>(std::ranges::count(seen, nullptr)) >= 2) {
      shared.push_back(instant);
    }
  }
  const auto apart = [&](std::size_t one, std::size_t other) {
    double sum = 0.0;
    for (std::size_t camera = 0; camera < views.size(); ++camera) {
      const BoardView* a = byInstant[shared[one]][camera];
      const BoardView* b = byInstant[shared[other]][camera];
      const auto moved =
          a != nullptr && b != nullptr ? motionBetween(a->detection, b->detection) : std::nullopt;
      sum += moved                              ? *moved / widths[camera]
             : (a == nullptr) != (b == nullptr) ? kSeenByOneOnly
                                                : 0.0;
    }
    return sum;
  };
  std::set<std::int64_t> chosen(shared.begin(), shared.end());
  if (shared.size() > static_cast<std::size_t>(count)) {
    chosen.clear();
    for (const std::size_t k : farApart(shared.size(), static_cast<std::size_t>(count), 0, apart)) {
      chosen.insert(shared[k]);
    }
  }
  std::vector<std::vector<BoardView>> result(views.size());
  for (std::size_t camera = 0; camera < views.size(); ++camera) {
    for (const BoardView& view : views[camera]) {
      const auto found = byInstant.find(view.instant);
      const bool isSharp = found != byInstant.end() && found->second[camera] != nullptr;
      if (view.instant == always || (isSharp && chosen.contains(view.instant))) {
        result[camera].push_back(view);
      }
    }
  }
  return result;
}

} // namespace dewpoint::calibration

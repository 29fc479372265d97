// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace dewpoint::observation {

/// Pieces a standing body is cut into, from the feet up.
inline constexpr int kBodyPieces = 6;

/// The silhouette of a standing person in a camera: one upright rectangle of pixels per piece of
/// the body, also outside the image, half open as OpenCV has it. `visible` is false when the camera
/// cannot show it (behind, or past its lens).
struct BodySilhouette {
  std::array<cv::Rect, kBodyPieces> pieces;
  bool visible = false;
};

/// Half the width of a piece of a body of `height`, meters: legs, hips, trunk, shoulders, head.
double bodyHalfWidth(int piece, double height);

/// Draws bodies for one camera; prepared once, cheap per body.
class SilhouetteMaker {
public:
  explicit SilhouetteMaker(const Camera& camera);

  /// The silhouette of a person of `height` meters who stands at `position` (world x and y, meters)
  /// on a floor at z = `floor` (m).
  BodySilhouette of(const Eigen::Vector2d& position, double floor, double height) const;
  /// Meters in front of the camera.
  double depth(const Eigen::Vector3d& point) const { return axis_.dot(point - center_); }

private:
  Projector projector_;
  Eigen::Vector3d center_;
  Eigen::Vector3d axis_;
  double focal_ = 0.0;
};

/// How much better or worse pixels fit to a person than to nobody, summed up so that the sum over
/// any rectangle takes four reads (Crow 1984): CV_32SC1, one row and column more than the image.
struct ScoreSums {
  static constexpr int kUnit = 40;     ///< of a score of 1, as a byte
  static constexpr int kNothing = 100; ///< the byte of a score of 0
  cv::Mat sums;

  /// From scores as bytes (CV_8UC1): kNothing + kUnit * score.
  void build(const cv::Mat& bytes);
  /// Mean over the pixels of a rectangle; what lies outside the image counts as nothing. NaN-free:
  /// 0 for an empty rectangle.
  double mean(const cv::Rect& area) const {
    const int left = std::max(0, area.x);
    const int top = std::max(0, area.y);
    const int right = std::min(sums.cols - 1, area.x + area.width);
    const int bottom = std::min(sums.rows - 1, area.y + area.height);
    if (left >= right || top >= bottom) {
      return 0.0;
    }
    const auto* above = sums.ptr<std::int32_t>(top);
    const auto* below = sums.ptr<std::int32_t>(bottom);
    const std::int32_t sum = below[right] - below[left] - above[right] + above[left] -
                             kNothing * (right - left) * (bottom - top);
    return static_cast<double>(sum) / (kUnit * static_cast<double>(area.area()));
  }
};

/// What a camera says about a person with this silhouette, in units of a fully visible one (1: all
/// of it is foreground). A piece says at least `floor` (not more than 0): it may be hidden by
/// furniture, or look like the room.
double bodyScore(const ScoreSums& score, const BodySilhouette& silhouette, double floor);

/// The same of the upper half of the body alone: legs are hidden more often than heads.
double upperBodyScore(const ScoreSums& score, const BodySilhouette& silhouette, double floor);

} // namespace dewpoint::observation

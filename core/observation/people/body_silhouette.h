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

/// Number of pieces into which a standing body is divided, from the feet up.
inline constexpr int kBodyPartCount = 6;

/// Silhouette of a standing person in a camera: one upright pixel rectangle per piece of the body,
/// half-open as in OpenCV. Rectangles may lie outside the image. `isVisible` is false if the camera
/// cannot show the person because the person is behind or very near the camera, or beyond the valid
/// range of its lens.
struct BodySilhouette {
  std::array<cv::Rect, kBodyPartCount> partRects;
  bool isVisible = false;
};

/// Returns half the width of a piece of a body with this `height`, meters. From piece 0 on, the
/// pieces are the legs (two pieces), hips, trunk, shoulders and head.
double bodyHalfWidth(int piece, double height);

/// Computes silhouettes in one camera. Create one object per camera and reuse it, because computing
/// a silhouette is then fast.
class SilhouetteProjector {
public:
  explicit SilhouetteProjector(const Camera& camera);

  /// Returns the silhouette of a person of `height` meters who stands at `position` (world x and y,
  /// meters) on a floor at z = `floor` (meters).
  BodySilhouette project(const Eigen::Vector2d& position, double floor, double height) const;
  /// Returns the distance (meters) of a world point from the camera along the optical axis. The
  /// result is negative for a point behind the camera.
  double depth(const Eigen::Vector3d& point) const { return axis_.dot(point - center_); }

private:
  Projector projector_;
  Eigen::Vector3d center_;
  Eigen::Vector3d axis_;
  double focal_ = 0.0;
};

/// Integral image of scores, from which the sum over any rectangle takes four reads (Crow 1984).
/// The score of a pixel is above 0 if the pixel fits a person better than no person, and below 0 if
/// it fits worse. `sums` is CV_32SC1, with one more row and column than the image.
struct ScoreSums {
  /// Change of the byte value for a change of the score by 1.
  static constexpr int kByteChangePerScore = 40;
  static constexpr int kZeroScoreByte = 100; ///< byte value of a score of 0
  cv::Mat sums;

  /// Builds the sums from scores stored as bytes (CV_8UC1): kZeroScoreByte + kByteChangePerScore *
  /// score.
  void build(const cv::Mat& bytes);
  /// Returns the mean score over a rectangle. Pixels outside the image have a score of 0. The
  /// result for an empty rectangle is 0, never NaN.
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
                             kZeroScoreByte * (right - left) * (bottom - top);
    return static_cast<double>(sum) / (kByteChangePerScore * static_cast<double>(area.area()));
  }
};

/// Returns the score of a camera for a person with this silhouette. The score is 1 for a fully
/// visible person whose whole silhouette is foreground. The score of each piece of the body is
/// limited to at least `floor`, which must be at most 0, because furniture may hide the piece, or
/// the piece may look like the background.
double bodyScore(const ScoreSums& score, const BodySilhouette& silhouette, double floor);

/// Returns the score of the upper half of the body only, computed like bodyScore(). Use this
/// function where the legs may be hidden.
double upperBodyScore(const ScoreSums& score, const BodySilhouette& silhouette, double floor);

} // namespace dewpoint::observation

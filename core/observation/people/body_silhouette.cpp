// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/people/body_silhouette.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace dewpoint::observation {
namespace {

/// Origin not recorded. Half widths of the pieces of a person of 1.75 m, meters: what is seen from
/// all sides, with swinging arms and legs.
constexpr std::array<double, kBodyPartCount> kHalfWidths{0.15, 0.15, 0.20, 0.23, 0.21, 0.10};
constexpr double kReferenceHeight = 1.75; ///< meters
constexpr int kFarOff = 1 << 14;          ///< pixels: so far outside it does not matter how far

int pixelOf(double value) {
  return static_cast<int>(std::lround(std::clamp(value, -double{kFarOff}, double{kFarOff})));
}

} // namespace

double bodyHalfWidth(int piece, double height) {
  return kHalfWidths.at(static_cast<std::size_t>(piece)) * height / kReferenceHeight;
}

SilhouetteProjector::SilhouetteProjector(const Camera& camera)
    : projector_(camera), center_(camera.center()), axis_(camera.opticalAxis()),
      focal_(std::sqrt(camera.intrinsics.focalX * camera.intrinsics.focalY)) {}

BodySilhouette SilhouetteProjector::project(const Eigen::Vector2d& position, double floor,
                                            double height) const {
  constexpr double kNearest = 0.2; // meters
  std::array<double, kBodyPartCount + 1> x;
  std::array<double, kBodyPartCount + 1> y;
  std::array<double, kBodyPartCount + 1> z;
  std::array<double, kBodyPartCount + 1> column;
  std::array<double, kBodyPartCount + 1> row;
  for (std::size_t k = 0; k <= kBodyPartCount; ++k) {
    x[k] = position.x();
    y[k] = position.y();
    z[k] = floor + height * static_cast<double>(k) / kBodyPartCount;
  }
  projector_.projectBatch(kBodyPartCount + 1, x.data(), y.data(), z.data(), column.data(),
                          row.data());
  BodySilhouette result;
  for (std::size_t k = 0; k < kBodyPartCount; ++k) {
    const double distance = depth({x[k], y[k], 0.5 * (z[k] + z[k + 1])});
    if (distance < kNearest || std::isnan(column[k] + column[k + 1])) {
      return result;
    }
    const double half = bodyHalfWidth(static_cast<int>(k), height) * focal_ / distance;
    const double center = 0.5 * (column[k] + column[k + 1]);
    const int left = pixelOf(center - half + 0.5);
    const int right = std::max(left + 1, pixelOf(center + half + 0.5));
    const int top = pixelOf(std::min(row[k], row[k + 1]) + 0.5);
    const int bottom = std::max(top + 1, pixelOf(std::max(row[k], row[k + 1]) + 0.5));
    result.partRects[k] = {left, top, right - left, bottom - top};
  }
  result.isVisible = true;
  return result;
}

void ScoreSums::build(const cv::Mat& bytes) {
  cv::integral(bytes, sums, CV_32S);
}

double bodyScore(const ScoreSums& score, const BodySilhouette& silhouette, double floor) {
  if (!silhouette.isVisible) {
    return 0.0;
  }
  double sum = 0.0;
  for (const cv::Rect& piece : silhouette.partRects) {
    sum += std::max(floor, score.mean(piece));
  }
  return sum / kBodyPartCount;
}

double upperBodyScore(const ScoreSums& score, const BodySilhouette& silhouette, double floor) {
  if (!silhouette.isVisible) {
    return 0.0;
  }
  double sum = 0.0;
  for (std::size_t k = kBodyPartCount / 2; k < kBodyPartCount; ++k) {
    sum += std::max(floor, score.mean(silhouette.partRects[k]));
  }
  constexpr auto kLower = kBodyPartCount - kBodyPartCount / 2;
  return sum / kLower;
}

} // namespace dewpoint::observation

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_coverage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::calibration {
namespace {
// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Radians (15 degrees): see tiltOf().
constexpr double kFlat = 15.0 * std::numbers::pi / 180.0;
} // namespace

BoardTilt tiltOf(const Eigen::Isometry3d& cameraFromBoard) {
  const Eigen::Vector3d away = cameraFromBoard.linear().col(2); // into the board
  if (std::acos(std::clamp(away.z(), -1.0, 1.0)) < kFlat) {
    return BoardTilt::Flat;
  }
  if (std::abs(away.x()) > std::abs(away.y())) {
    return away.x() > 0.0 ? BoardTilt::RightNear : BoardTilt::LeftNear;
  }
  return away.y() > 0.0 ? BoardTilt::BottomNear : BoardTilt::TopNear;
}

double tiltAngle(const Eigen::Isometry3d& cameraFromBoard, const Eigen::Vector3d& boardCenter) {
  const Eigen::Vector3d direction = (cameraFromBoard * boardCenter).normalized();
  return std::acos(std::clamp(direction.dot(cameraFromBoard.linear().col(2)), -1.0, 1.0));
}

int BoardCoverage::regionOf(const Eigen::Vector2d& pixel, int width, int height) {
  const auto cell = [](double share, int size, int count) {
    return std::clamp(static_cast<int>((share + 0.5) / size * count), 0, count - 1);
  };
  return cell(pixel.y(), height, kRows) * kColumns + cell(pixel.x(), width, kColumns);
}

void BoardCoverage::add(const std::vector<Eigen::Vector2d>& pixels, BoardTilt tilt, int width,
                        int height) {
  for (const auto& pixel : pixels) {
    ++cornerCounts[static_cast<std::size_t>(regionOf(pixel, width, height))];
  }
  ++tiltCounts[static_cast<std::size_t>(tilt)];
}

double BoardCoverage::coveredFraction() const {
  const auto seen = std::ranges::count_if(cornerCounts, [](int count) { return count > 0; });
  return static_cast<double>(seen) / static_cast<double>(cornerCounts.size());
}

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/view_fit.h"

#include "core/base/statistics.h"
#include "core/calibration/board/board_coverage.h"
#include "core/calibration/board/opencv_pose.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Corners of a usable view.
constexpr std::size_t kLeastCorners = 6;
/// A view is bad beyond so many medians of the views, ...
constexpr double kBadFactor = 5.0;
constexpr double kBadPart = 0.0025; // 2 px of 640x480
/// A view is doubtful beyond so many medians.
constexpr double kDoubtfulFactor = 3.0;
constexpr double kUnseenPx = 1e3; // a corner that the model cannot show

} // namespace

ViewFit fitView(const BoardDescription& board, const BoardView& view, const Camera& camera,
                const Eigen::Isometry3d& cameraFromBoard) {
  ViewFit fit;
  fit.name = view.name;
  fit.instant = view.instant;
  fit.cameraFromBoard = cameraFromBoard;
  fit.tiltAngle = tiltAngle(cameraFromBoard, board.center());
  fit.ids = view.detection.ids;
  fit.pixels = view.detection.pixels;
  Camera placed = camera;
  placed.cameraFromWorld = cameraFromBoard;
  const Projector projector(placed);
  double squares = 0.0;
  for (std::size_t k = 0; k < fit.ids.size(); ++k) {
    const auto projected = projector.project(board.corner(fit.ids[k]));
    fit.residuals.push_back(projected ? Eigen::Vector2d(fit.pixels[k] - *projected)
                                      : Eigen::Vector2d::Constant(kUnseenPx));
    squares += fit.residuals.back().squaredNorm();
  }
  fit.rmsPx = std::sqrt(squares / static_cast<double>(fit.ids.size()));
  return fit;
}

ViewFit leftOutView(const BoardView& view, std::string reason) {
  ViewFit fit;
  fit.name = view.name;
  fit.instant = view.instant;
  fit.isUsed = false;
  fit.reason = std::move(reason);
  fit.ids = view.detection.ids;
  fit.pixels = view.detection.pixels;
  return fit;
}

double medianRms(const std::vector<ViewFit>& fits) {
  std::vector<double> errors;
  errors.reserve(fits.size());
  for (const ViewFit& fit : fits) {
    errors.push_back(fit.rmsPx);
  }
  return upperMedian(std::move(errors));
}

double maxViewErrorPx(double median, const Intrinsics& image) {
  return std::max(kBadFactor * median, kBadPart * std::hypot(image.width, image.height));
}

void markDoubtful(std::vector<ViewFit>& fits) {
  const double median = medianRms(fits);
  for (ViewFit& fit : fits) {
    if (fit.isUsed && fit.rmsPx > kDoubtfulFactor * median) {
      fit.isDoubtful = true;
      fit.reason = fmt::format(
          "the corners in this image are {:.2f} px off, those in the median image {:.2f} px",
          fit.rmsPx, median);
    }
  }
}

double overallRms(const std::vector<ViewFit>& fits) {
  double squares = 0.0;
  double count = 0.0;
  for (const ViewFit& fit : fits) {
    if (fit.isUsed) {
      squares += fit.rmsPx * fit.rmsPx * static_cast<double>(fit.ids.size());
      count += static_cast<double>(fit.ids.size());
    }
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

bool spansPlane(const BoardDescription& board, const BoardDetection& detection) {
  int rows = 0;
  int columns = 0;
  std::vector<bool> row(static_cast<std::size_t>(board.cornerRows()));
  std::vector<bool> column(static_cast<std::size_t>(board.cornerColumns()));
  for (const int id : detection.ids) {
    auto inRow = row[static_cast<std::size_t>(id / board.cornerColumns())];
    auto inColumn = column[static_cast<std::size_t>(id % board.cornerColumns())];
    rows += inRow ? 0 : 1;
    columns += inColumn ? 0 : 1;
    inRow = true;
    inColumn = true;
  }
  return detection.ids.size() >= kLeastCorners && rows >= 2 && columns >= 2;
}

std::optional<Eigen::Isometry3d> boardPose(const BoardDescription& board,
                                           const BoardDetection& detection, const Camera& camera) {
  Camera atOrigin = camera;
  atOrigin.cameraFromWorld.setIdentity();
  const Unprojector unprojector(atOrigin);
  std::vector<cv::Point3d> corners;
  std::vector<cv::Point2d> directions;
  for (std::size_t k = 0; k < detection.ids.size(); ++k) {
    const auto ray = unprojector.worldDirection(detection.pixels[k]);
    if (ray && ray->z() > 1e-3) {
      const Eigen::Vector3d corner = board.corner(detection.ids[k]);
      corners.emplace_back(corner.x(), corner.y(), corner.z());
      directions.emplace_back(ray->x() / ray->z(), ray->y() / ray->z());
    }
  }
  if (!spansPlane(board, detection) || corners.size() < kLeastCorners) {
    return std::nullopt;
  }
  try {
    cv::Mat rotation;
    cv::Mat translation;
    const cv::Mat ideal = cv::Mat::eye(3, 3, CV_64F);
    if (!cv::solvePnP(corners, directions, ideal, cv::noArray(), rotation, translation, false,
                      cv::SOLVEPNP_IPPE) ||
        !cv::solvePnP(corners, directions, ideal, cv::noArray(), rotation, translation, true,
                      cv::SOLVEPNP_ITERATIVE)) {
      return std::nullopt;
    }
    return poseFromOpenCv(rotation, translation);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
}

} // namespace dewpoint::calibration

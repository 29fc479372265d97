// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/intrinsics_covariance.h"

#include "core/base/statistics.h"
#include "core/geometry/linear_algebra.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace dewpoint::calibration {
namespace {

constexpr int kPose = 6;
constexpr int kGrid = 9;
constexpr std::size_t kMostLensBlocks = 10; ///< as leaveOutBlocks()
constexpr std::size_t kLeastBlocks = 4;
constexpr double kPoseStep = 1e-6; // radians, and meters per meter of distance

/// Pixels of points in the camera's frame, one below the other; points not seen stay at NaN.
Eigen::VectorXd imageOf(const Camera& camera, const std::vector<Eigen::Vector3d>& pointsCamera) {
  Camera atOrigin = camera;
  atOrigin.cameraFromWorld.setIdentity();
  const Projector projector(atOrigin);
  Eigen::VectorXd image(2 * static_cast<Eigen::Index>(pointsCamera.size()));
  for (std::size_t k = 0; k < pointsCamera.size(); ++k) {
    image.segment<2>(2 * static_cast<Eigen::Index>(k)) =
        projector.project(pointsCamera[k]).value_or(Eigen::Vector2d::Constant(std::nan("")));
  }
  return image;
}

/// Derivatives of the image by the intrinsics.
Eigen::MatrixXd byIntrinsics(const Camera& camera, const IntrinsicsParameters& parameters,
                             const std::vector<Eigen::Vector3d>& pointsCamera) {
  const Eigen::VectorXd values = parameters.valuesOf(camera);
  const Eigen::VectorXd steps = parameters.stepSizes(camera);
  Eigen::MatrixXd derivative(2 * static_cast<Eigen::Index>(pointsCamera.size()), values.size());
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(values.size());
    step(k) = steps(k);
    derivative.col(k) = (imageOf(parameters.withValues(camera, values + step), pointsCamera) -
                         imageOf(parameters.withValues(camera, values - step), pointsCamera)) /
                        (2.0 * steps(k));
  }
  return derivative;
}

std::vector<Eigen::Vector3d> moved(const std::vector<Eigen::Vector3d>& points, int axis,
                                   double step) {
  const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis % 3);
  std::vector<Eigen::Vector3d> result;
  result.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    result.push_back(axis < 3 ? Eigen::Vector3d(Eigen::AngleAxisd(step, unit) * point)
                              : Eigen::Vector3d(point + step * unit));
  }
  return result;
}

/// Derivatives of the image by the first `count` of: turns about the axes, shifts along them.
Eigen::MatrixXd byPose(const Camera& camera, const std::vector<Eigen::Vector3d>& pointsCamera,
                       int count) {
  Eigen::MatrixXd derivative(2 * static_cast<Eigen::Index>(pointsCamera.size()), count);
  for (int axis = 0; axis < count; ++axis) {
    derivative.col(axis) = (imageOf(camera, moved(pointsCamera, axis, kPoseStep)) -
                            imageOf(camera, moved(pointsCamera, axis, -kPoseStep))) /
                           (2.0 * kPoseStep);
  }
  return derivative;
}

/// The inverse of a normal matrix, scaled to a unit diagonal: focal lengths and k3 differ by many
/// powers of ten.
std::optional<Eigen::MatrixXd> scaledInverse(const Eigen::MatrixXd& normal) {
  const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  if (!scaled.allFinite()) {
    return std::nullopt;
  }
  const auto inverse = geometry::inversePositiveDefinite(scaled);
  if (!inverse) {
    return std::nullopt;
  }
  return Eigen::MatrixXd(scale.asDiagonal() * *inverse * scale.asDiagonal());
}

} // namespace

IntrinsicsParameters::IntrinsicsParameters(IntrinsicsModel model, bool squarePixels)
    : squarePixels_(squarePixels), coefficients_(model == IntrinsicsModel::Fisheye            ? 4
                                                 : model == IntrinsicsModel::FiveCoefficients ? 5
                                                                                              : 8) {
  names_ = squarePixels ? std::vector<std::string>{"f"} : std::vector<std::string>{"fx", "fy"};
  names_.insert(names_.end(), {"cx", "cy"});
  const std::vector<std::string> lens =
      model == IntrinsicsModel::Fisheye
          ? std::vector<std::string>{"k1", "k2", "k3", "k4"}
          : std::vector<std::string>{"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  names_.insert(names_.end(), lens.begin(), lens.begin() + coefficients_);
}

Eigen::VectorXd IntrinsicsParameters::valuesOf(const Camera& camera) const {
  std::vector<double> values{camera.intrinsics.focalX};
  if (!squarePixels_) {
    values.push_back(camera.intrinsics.focalY);
  }
  values.insert(values.end(), {camera.intrinsics.centerX, camera.intrinsics.centerY});
  values.insert(values.end(), camera.distortion.begin(), camera.distortion.begin() + coefficients_);
  return Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Camera IntrinsicsParameters::withValues(Camera camera, const Eigen::VectorXd& values) const {
  Eigen::Index at = 0;
  camera.intrinsics.focalX = values(at++);
  camera.intrinsics.focalY = squarePixels_ ? camera.intrinsics.focalX : values(at++);
  camera.intrinsics.centerX = values(at++);
  camera.intrinsics.centerY = values(at++);
  for (int k = 0; k < coefficients_; ++k) {
    camera.distortion[static_cast<std::size_t>(k)] = values(at++);
  }
  return camera;
}

Eigen::VectorXd IntrinsicsParameters::stepSizes(const Camera& camera) const {
  Eigen::VectorXd steps = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(names_.size()), 1e-5);
  steps.head(squarePixels_ ? 3 : 4).setConstant(1e-5 * camera.intrinsics.focalX);
  return steps;
}

std::vector<ViewNormalEquations> normalEquationsOfViews(const BoardDescription& board,
                                                        const Camera& camera,
                                                        const IntrinsicsParameters& parameters,
                                                        const std::vector<ViewFit>& views) {
  std::vector<ViewNormalEquations> all;
  for (const ViewFit& view : views) {
    std::vector<Eigen::Vector3d> points;
    for (const int id : view.ids) {
      points.push_back(view.cameraFromBoard * board.corner(id));
    }
    const Eigen::MatrixXd lens = byIntrinsics(camera, parameters, points);
    const Eigen::MatrixXd pose = byPose(camera, points, kPose);
    if (!view.isUsed || !lens.allFinite() || !pose.allFinite()) {
      continue;
    }
    Eigen::VectorXd residuals(2 * static_cast<Eigen::Index>(points.size()));
    for (std::size_t k = 0; k < points.size(); ++k) {
      residuals.segment<2>(2 * static_cast<Eigen::Index>(k)) = view.residuals[k];
    }
    const Eigen::MatrixXd cross = pose.transpose() * lens;
    const Eigen::MatrixXd rest =
        lens - pose * geometry::solveSymmetric(pose.transpose() * pose, cross);
    all.push_back({view.instant, rest.transpose() * rest, rest.transpose() * residuals});
  }
  std::ranges::stable_sort(all, {}, &ViewNormalEquations::instant);
  return all;
}

Eigen::MatrixXd intrinsicsCovariance(const BoardDescription& board, const Camera& camera,
                                     const IntrinsicsParameters& parameters,
                                     const std::vector<ViewFit>& views) {
  const auto size = static_cast<Eigen::Index>(parameters.names().size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  const auto evidence = normalEquationsOfViews(board, camera, parameters, views);
  for (const ViewNormalEquations& view : evidence) {
    normal += view.information;
  }
  double squares = 0.0;
  Eigen::Index freedom = -size;
  for (const ViewFit& view : views) {
    if (!view.isUsed) {
      continue;
    }
    for (const Eigen::Vector2d& residual : view.residuals) {
      squares += residual.squaredNorm();
    }
    freedom += 2 * static_cast<Eigen::Index>(view.ids.size()) - kPose;
  }
  const auto inverse = scaledInverse(normal);
  if (freedom <= 0 || !inverse) {
    return {};
  }
  return squares / static_cast<double>(freedom) * *inverse;
}

Eigen::VectorXd lensChangeWithoutViews(const std::vector<ViewNormalEquations>& evidence,
                                       std::int64_t first, std::int64_t end) {
  const Eigen::Index size = evidence.empty() ? 0 : evidence.front().gradient.size();
  Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd left = Eigen::VectorXd::Zero(size);
  for (const ViewNormalEquations& view : evidence) {
    if (view.instant >= first && view.instant < end) {
      left += view.gradient;
    } else {
      rest += view.information;
    }
  }
  const auto inverse = scaledInverse(rest);
  return inverse ? Eigen::VectorXd(-*inverse * left) : Eigen::VectorXd(Eigen::VectorXd::Zero(size));
}

Camera lensWithoutViews(const IntrinsicsResult& result, std::int64_t first, std::int64_t end) {
  if (result.viewNormalEquations.empty()) {
    return result.camera;
  }
  // The names tell how many parameters there are; the camera tells the model.
  const bool square = result.parameters.front().name == "f";
  const auto coefficients = result.parameters.size() - (square ? 3 : 4);
  const IntrinsicsParameters parameters(result.camera.lens == LensModel::Fisheye
                                            ? IntrinsicsModel::Fisheye
                                        : coefficients == 5 ? IntrinsicsModel::FiveCoefficients
                                                            : IntrinsicsModel::EightCoefficients,
                                        square);
  return parameters.withValues(result.camera,
                               parameters.valuesOf(result.camera) +
                                   lensChangeWithoutViews(result.viewNormalEquations, first, end));
}

Eigen::MatrixXd lensJackknifeCovariance(const std::vector<ViewNormalEquations>& evidence) {
  const std::size_t count = evidence.size();
  const std::size_t blocks = std::min(kMostLensBlocks, count);
  if (blocks < kLeastBlocks) {
    return {};
  }
  Eigen::MatrixXd changes(evidence.front().gradient.size(), static_cast<Eigen::Index>(blocks));
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t end = (block + 1) * count / blocks;
    changes.col(static_cast<Eigen::Index>(block)) = lensChangeWithoutViews(
        evidence, evidence[block * count / blocks].instant,
        end < count ? evidence[end].instant : std::numeric_limits<std::int64_t>::max());
  }
  const auto number = static_cast<double>(blocks);
  const double factor = std::sqrt((number - 1.0) / number) * studentQuantile95(number - 1.0) /
                        studentQuantile95(std::numeric_limits<double>::infinity());
  const Eigen::MatrixXd apart = factor * (changes.colwise() - changes.rowwise().mean());
  return apart * apart.transpose();
}

Eigen::MatrixXd widenedCovariance(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& found) {
  if (found.size() == 0 || covariance.size() == 0) {
    return covariance;
  }
  const Eigen::VectorXd wider =
      (found.diagonal().array() / covariance.diagonal().array()).max(1.0).sqrt().matrix();
  return wider.asDiagonal() * covariance * wider.asDiagonal();
}

double projectionSigma(const Camera& camera, const IntrinsicsParameters& parameters,
                       const Eigen::MatrixXd& covariance) {
  Camera atOrigin = camera;
  atOrigin.cameraFromWorld.setIdentity();
  const Unprojector unprojector(atOrigin);
  std::vector<Eigen::Vector3d> rays;
  for (int k = 0; k < kGrid * kGrid; ++k) {
    const int column = k % kGrid;
    const int row = k / kGrid;
    const Eigen::Vector2d pixel((camera.intrinsics.width - 1.0) * column / (kGrid - 1.0),
                                (camera.intrinsics.height - 1.0) * row / (kGrid - 1.0));
    const auto ray = unprojector.worldDirection(pixel);
    // Derivatives need some room up to where the model ends.
    if (ray &&
        Projector(atOrigin).project(*ray + 1e-3 * Eigen::Vector3d(ray->x(), ray->y(), 0.0))) {
      rays.push_back(*ray);
    }
  }
  const Eigen::MatrixXd lens = byIntrinsics(camera, parameters, rays);
  const Eigen::MatrixXd turn = byPose(camera, rays, 3);
  if (covariance.size() == 0 || rays.empty() || !lens.allFinite() || !turn.allFinite()) {
    return std::numeric_limits<double>::infinity();
  }
  const Eigen::MatrixXd rest = lens - turn * geometry::leastSquares(turn, lens);
  const Eigen::MatrixXd variance = rest * covariance * rest.transpose();
  double worst = 0.0;
  for (Eigen::Index k = 0; k < variance.rows(); k += 2) {
    worst = std::max(worst, 0.5 * (variance(k, k) + variance(k + 1, k + 1)));
  }
  return std::sqrt(worst); // per axis
}

} // namespace dewpoint::calibration

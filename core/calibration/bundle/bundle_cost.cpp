// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle/bundle_cost.h"

#include "core/geometry/rotation_vector.h"

#include <Eigen/Geometry>

#include <ceres/jet.h>
#include <cmath>
#include <utility>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Radians, below which rotations are taken to first order: exact to rounding there.
constexpr double kSmallAngle = 1e-7;

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// The pixel of a point in camera axes: Projection's models, for numbers that carry derivatives.
template <typename T> std::array<T, 2> lensPixel(LensModel lens, const T* k, T x, T y, T z) {
  using std::atan;
  using std::sqrt;
  T u = x / z;
  T v = y / z;
  const T s = u * u + v * v;
  const T* d = k + 4;
  if (lens == LensModel::Fisheye) {
    if (s > T(1e-16)) {
      const T radius = sqrt(s);
      const T angle = atan(radius);
      const T t = angle * angle;
      const T factor = angle * (T(1) + t * (d[0] + t * (d[1] + t * (d[2] + t * d[3])))) / radius;
      u *= factor;
      v *= factor;
    }
  } else {
    const T factor =
        (T(1) + s * (d[0] + s * (d[1] + s * d[4]))) / (T(1) + s * (d[5] + s * (d[6] + s * d[7])));
    const T du = T(2) * d[2] * u * v + d[3] * (s + T(2) * u * u);
    const T dv = d[2] * (s + T(2) * v * v) + T(2) * d[3] * u * v;
    u = u * factor + du;
    v = v * factor + dv;
  }
  return {k[0] * u + k[2], k[0] * k[1] * v + k[3]};
}

/// The pixel with its derivatives by the point and, where asked for, by the lens.
struct LensImage {
  Eigen::Vector2d pixel;
  Eigen::Matrix<double, 2, 3> byPoint;
  Eigen::Matrix<double, 2, kLensSize, Eigen::RowMajor> byLens;
};

template <int Size>
LensImage imageWith(LensModel lens, const double* block, const Eigen::Vector3d& point) {
  using Jet = ceres::Jet<double, Size>;
  std::array<Jet, kLensSize> k;
  for (int i = 0; i < kLensSize; ++i) {
    k[std::size_t(i)] = Size > 3 ? Jet(block[i], (3 + i) % Size) : Jet(block[i]);
  }
  const auto pixel =
      lensPixel(lens, k.data(), Jet(point.x(), 0), Jet(point.y(), 1), Jet(point.z(), 2));
  LensImage image;
  for (int row = 0; row < 2; ++row) {
    const Jet& value = pixel[std::size_t(row)];
    image.pixel[row] = value.a;
    image.byPoint.row(row) = value.v.template head<3>().transpose();
    if constexpr (Size > 3) {
      image.byLens.row(row) = value.v.template tail<kLensSize>().transpose();
    }
  }
  return image;
}

/// Lagrange's weights of the knots at a time, and their derivatives by the time.
void pathWeights(const std::vector<double>& knots, double time, std::vector<double>& weights,
                 std::vector<double>& slopes) {
  const std::size_t count = knots.size();
  weights.assign(count, 1.0);
  slopes.assign(count, 0.0);
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t m = 0; m < count; ++m) {
      if (m == j) {
        continue;
      }
      const double inverse = 1.0 / (knots[j] - knots[m]);
      slopes[j] = slopes[j] * (time - knots[m]) * inverse + weights[j] * inverse;
      weights[j] *= (time - knots[m]) * inverse;
    }
  }
}

} // namespace

std::array<double, kLensSize> lensBlock(const Camera& camera) {
  std::array<double, kLensSize> block{};
  const Intrinsics& in = camera.intrinsics;
  block = {in.focalX, in.focalY / in.focalX, in.centerX, in.centerY};
  for (std::size_t i = 0; i < 8; ++i) {
    block[4 + i] = camera.distortion[i];
  }
  return block;
}

void setLens(const std::array<double, kLensSize>& block, Camera& camera) {
  camera.intrinsics.focalX = block[0];
  camera.intrinsics.focalY = block[0] * block[1];
  camera.intrinsics.centerX = block[2];
  camera.intrinsics.centerY = block[3];
  for (std::size_t i = 0; i < 8; ++i) {
    camera.distortion[i] = block[4 + i];
  }
}

Eigen::Matrix3d rotationExponential(const Eigen::Vector3d& turn) {
  return turn.norm() < kSmallAngle
             ? Eigen::Matrix3d(Eigen::Matrix3d::Identity() + crossMatrix(turn))
             : rotationFromVector(turn);
}

Eigen::Matrix3d rotationExponentialDerivative(const Eigen::Vector3d& turn,
                                              const Eigen::Vector3d& rotatedPoint) {
  const double angle = turn.norm();
  Eigen::Matrix3d left = Eigen::Matrix3d::Identity() + 0.5 * crossMatrix(turn);
  if (angle >= kSmallAngle) {
    const Eigen::Vector3d axis = turn / angle;
    const double sine = std::sin(angle) / angle;
    left = sine * Eigen::Matrix3d::Identity() + (1.0 - sine) * axis * axis.transpose() +
           (1.0 - std::cos(angle)) / angle * crossMatrix(axis);
  }
  return -crossMatrix(rotatedPoint) * left;
}

PixelCost::PixelCost(PixelCostSetup setup) : setup_(std::move(setup)) {
  set_num_residuals(2);
  auto* sizes = mutable_parameter_block_sizes();
  *sizes = {kPoseSize, kLensSize, 1};
  const std::size_t states = setup_.knotTimes.empty() ? 1 : setup_.knotTimes.size();
  sizes->insert(sizes->end(), states, setup_.stateBlockSize);
}

bool PixelCost::Evaluate(double const* const* parameters, double* residuals,
                         double** jacobians) const {
  using Block = Eigen::Map<Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::RowMajor>>;
  const Eigen::Map<const Eigen::Vector3d> turn(parameters[0]);
  const Eigen::Map<const Eigen::Vector3d> center(parameters[0] + 3);
  const std::size_t states = parameter_block_sizes().size() - 3;
  Eigen::Vector3d world = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d boardTurn = Eigen::Vector3d::Zero();
  Eigen::Vector3d onBoard = Eigen::Vector3d::Zero();
  std::vector<double> weights(1, 1.0);
  std::vector<double> slopes(1, 0.0);
  if (setup_.boardRotation) {
    boardTurn = Eigen::Map<const Eigen::Vector3d>(parameters[3]);
    onBoard = rotationExponential(boardTurn) * (*setup_.boardRotation * setup_.boardPoint);
    world = onBoard + Eigen::Map<const Eigen::Vector3d>(parameters[3] + 3);
  } else {
    if (states > 1) {
      pathWeights(setup_.knotTimes, setup_.imageTime + parameters[2][0], weights, slopes);
    }
    for (std::size_t j = 0; j < states; ++j) {
      const Eigen::Map<const Eigen::Vector3d> knot(parameters[3 + j] + setup_.pointOffset);
      world += weights[j] * knot;
      velocity += slopes[j] * knot;
    }
  }
  const Eigen::Matrix3d rotation = rotationExponential(turn) * setup_.cameraRotation;
  const Eigen::Vector3d inCamera = rotation * (world - center);
  if (!(inCamera.z() > 1e-6)) {
    return false;
  }
  const Eigen::Vector3d flatten(1.0, 1.0, 1.0 - setup_.outlineShift);
  const Eigen::Vector3d seen = flatten.cwiseProduct(inCamera);
  const bool lensRequested = jacobians != nullptr && jacobians[1] != nullptr;
  const LensImage image = lensRequested ? imageWith<3 + kLensSize>(setup_.lens, parameters[1], seen)
                                        : imageWith<3>(setup_.lens, parameters[1], seen);
  Eigen::Map<Eigen::Vector2d>(residuals).noalias() = (image.pixel - setup_.pixel) / setup_.sigma;
  if (!std::isfinite(residuals[0]) || !std::isfinite(residuals[1])) {
    return false;
  }
  if (jacobians == nullptr) {
    return true;
  }
  const Eigen::Matrix<double, 2, 3> byCamera = image.byPoint * flatten.asDiagonal() / setup_.sigma;
  const Eigen::Matrix<double, 2, 3> byWorld = byCamera * rotation;
  if (jacobians[0] != nullptr) {
    Block block(jacobians[0], 2, kPoseSize);
    block.leftCols<3>() = byCamera * rotationExponentialDerivative(turn, inCamera);
    block.rightCols<3>() = -byWorld;
  }
  if (lensRequested) {
    Block(jacobians[1], 2, kLensSize) = image.byLens / setup_.sigma;
  }
  if (jacobians[2] != nullptr) {
    Block(jacobians[2], 2, 1) = byWorld * velocity;
  }
  for (std::size_t j = 0; j < states; ++j) {
    if (jacobians[3 + j] == nullptr) {
      continue;
    }
    Block block(jacobians[3 + j], 2, setup_.stateBlockSize);
    block.setZero();
    if (setup_.boardRotation) {
      block.leftCols<3>() = byWorld * rotationExponentialDerivative(boardTurn, onBoard);
      block.rightCols<3>() = byWorld;
    } else {
      block.middleCols<3>(setup_.pointOffset) = weights[j] * byWorld;
    }
  }
  return true;
}

bool StickCost::Evaluate(double const* const* parameters, double* residuals,
                         double** jacobians) const {
  const Eigen::Vector3d way = Eigen::Map<const Eigen::Vector3d>(parameters[0] + 3) -
                              Eigen::Map<const Eigen::Vector3d>(parameters[0]);
  const double distance = way.norm();
  residuals[0] = (distance - length_) / sigma_;
  if (jacobians != nullptr && jacobians[0] != nullptr) {
    const Eigen::Vector3d slope = way / (std::max(distance, 1e-12) * sigma_);
    Eigen::Map<Eigen::Vector3d>{jacobians[0]} = -slope;
    Eigen::Map<Eigen::Vector3d>{jacobians[0] + 3} = slope;
  }
  return true;
}

PriorCost::PriorCost(std::vector<double> start, std::vector<double> sigmas)
    : start_(std::move(start)), sigmas_(std::move(sigmas)) {
  set_num_residuals(static_cast<int>(start_.size()));
  mutable_parameter_block_sizes()->push_back(static_cast<int>(start_.size()));
}

bool PriorCost::Evaluate(double const* const* parameters, double* residuals,
                         double** jacobians) const {
  const std::size_t size = start_.size();
  if (jacobians != nullptr && jacobians[0] != nullptr) {
    std::fill_n(jacobians[0], size * size, 0.0);
  }
  for (std::size_t i = 0; i < size; ++i) {
    const double weight = sigmas_[i] > 0.0 ? 1.0 / sigmas_[i] : 0.0;
    residuals[i] = weight * (parameters[0][i] - start_[i]);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      jacobians[0][i * size + i] = weight;
    }
  }
  return true;
}

} // namespace dewpoint::calibration

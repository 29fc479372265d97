// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/moved_camera_pose.h"

#include "core/base/statistics.h"
#include "core/calibration/bundle/bundle_cost.h"
#include "core/geometry/rotation_check.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace dewpoint::calibration {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kHuber = 2.0;        // sigmas
constexpr double kAgrees = 3.0;       // sigmas
constexpr double kBackgroundAt = 3.0; // metres
constexpr double kStep = 1e-6;        // radians and metres, of the differences
constexpr int kMostRounds = 50;
constexpr double kUnseen = 50.0; // pixels a sighting counts as off that the camera cannot see

/// The camera after a turn (rad) about its center and a shift (m) of it, both in camera axes.
Camera movedCamera(const Camera& camera, const Vector6& change) {
  Camera moved = turnedCamera(camera, change.head<3>());
  moved.cameraFromWorld.translation() -= change.tail<3>();
  return moved;
}

/// A change of the pose, as what it does to points in camera axes.
struct PointMotion {
  Eigen::Matrix3d turn;
  Eigen::Vector3d shift;

  explicit PointMotion(const Vector6& change)
      : turn(rotationOfVector(change.head<3>())), shift(change.tail<3>()) {}
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return turn * point - shift; }
};

Camera atOrigin(Camera camera) {
  camera.cameraFromWorld.setIdentity();
  return camera;
}

/// Off by so many sigma, for a point in the axes that the projector starts from.
std::optional<Eigen::Vector2d> residual(const Projector& lens, const Eigen::Vector3d& point,
                                        const PointSighting& sighting) {
  const auto pixel = lens.project(point);
  if (!pixel) {
    return std::nullopt;
  }
  return Eigen::Vector2d((*pixel - sighting.pixel) / sighting.sigmaPixels);
}

/// Normal equations of the sightings and the prior at `change`, and the cost there.
struct Normal {
  Matrix6 matrix = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double cost = 0.0;
};

class Solver {
public:
  Solver(const Camera& camera, const CameraMotionPrior& prior,
         std::span<const PointSighting> sightings)
      : camera_(camera), lens_(atOrigin(camera)), sightings_(sightings) {
    mean_ << prior.turn, Eigen::Vector3d::Zero();
    const double turn = std::hypot(prior.turnSigma, prior.shiftSigma / kBackgroundAt);
    weights_ << Eigen::Vector3d::Constant(1.0 / (turn * turn)),
        Eigen::Vector3d::Constant(1.0 / (prior.shiftSigma * prior.shiftSigma));
  }

  Normal at(const Vector6& change) const {
    Normal normal;
    const Vector6 offset = change - mean_;
    normal.matrix.diagonal() = weights_;
    normal.right = weights_.cwiseProduct(offset);
    normal.cost = 0.5 * offset.dot(normal.right);
    const PointMotion here(change);
    std::vector<PointMotion> ahead;
    for (int k = 0; k < 6; ++k) {
      ahead.emplace_back(change + kStep * Vector6::Unit(k));
    }
    for (const PointSighting& sighting : sightings_) {
      add(sighting, here, ahead, normal);
    }
    return normal;
  }

  /// The change of least cost, from the prior's.
  Vector6 solve() const {
    Vector6 change = mean_;
    Normal normal = at(change);
    double damping = 1e-6;
    for (int round = 0; round < kMostRounds; ++round) {
      Matrix6 damped = normal.matrix;
      damped.diagonal() *= 1.0 + damping;
      const Vector6 step = damped.ldlt().solve(normal.right);
      const Normal next = at(change - step);
      if (next.cost < normal.cost) {
        change -= step;
        const bool done = normal.cost - next.cost < 1e-12 * normal.cost;
        normal = next;
        damping *= 0.1;
        if (done) {
          break;
        }
      } else if ((damping *= 10.0) > 1e8) {
        break;
      }
    }
    return change;
  }

private:
  void add(const PointSighting& sighting, const PointMotion& here,
           const std::vector<PointMotion>& ahead, Normal& normal) const {
    const Eigen::Vector3d point = camera_.cameraFromWorld * sighting.world;
    const auto off = residual(lens_, here * point, sighting);
    if (!off) {
      normal.cost += kHuber * kUnseen / sighting.sigmaPixels;
      return;
    }
    Eigen::Matrix<double, 2, 6> byChange;
    for (int k = 0; k < 6; ++k) {
      const auto there = residual(lens_, ahead[std::size_t(k)] * point, sighting);
      byChange.col(k) = there ? Eigen::Vector2d((*there - *off) / kStep) : Eigen::Vector2d::Zero();
    }
    const double distance = off->norm();
    const double weight = distance > kHuber ? kHuber / distance : 1.0;
    normal.matrix += weight * byChange.transpose() * byChange;
    normal.right += weight * byChange.transpose() * *off;
    normal.cost +=
        distance > kHuber ? kHuber * (distance - 0.5 * kHuber) : 0.5 * distance * distance;
  }

  const Camera& camera_;
  Projector lens_; ///< the camera at the world's origin
  std::span<const PointSighting> sightings_;
  Vector6 mean_, weights_;
};

double medianPixels(const Camera& camera, std::span<const PointSighting> sightings) {
  const Projector projector(camera);
  std::vector<double> distances;
  for (const PointSighting& sighting : sightings) {
    const auto off = residual(projector, sighting.world, sighting);
    distances.push_back(off ? off->norm() * sighting.sigmaPixels : kUnseen);
  }
  return upperMedian(std::move(distances));
}

} // namespace

Camera turnedCamera(const Camera& camera, const Eigen::Vector3d& turn) {
  Camera turned = camera;
  Eigen::Isometry3d rotation = Eigen::Isometry3d::Identity();
  rotation.linear() = rotationOfVector(turn);
  turned.cameraFromWorld = rotation * camera.cameraFromWorld;
  return turned;
}

Result<ResolvedCamera> resolveCamera(const Camera& camera, const CameraMotionPrior& prior,
                                     std::span<const PointSighting> sightings) {
  const Solver solver(camera, prior, sightings);
  const Vector6 change = solver.solve();
  ResolvedCamera resolved;
  resolved.camera = movedCamera(camera, change);
  resolved.pixelsBefore = medianPixels(camera, sightings);
  resolved.pixelsAfter = medianPixels(resolved.camera, sightings);
  const Matrix6 covariance = solver.at(change).matrix.inverse();
  resolved.angleSigma = covariance.diagonal().head<3>().cwiseSqrt();
  resolved.shiftSigma = covariance.diagonal().tail<3>().cwiseSqrt();
  const Projector projector(resolved.camera);
  for (const PointSighting& sighting : sightings) {
    const auto off = residual(projector, sighting.world, sighting);
    resolved.used += off && off->norm() < kAgrees ? 1 : 0;
  }
  if (2 * std::size_t(resolved.used) < sightings.size()) {
    return failure(ErrorCode::Mismatch, "", camera.name,
                   fmt::format("only {} of {} sightings agree with any pose near the old one; "
                               "calibrate this camera again",
                               resolved.used, sightings.size()));
  }
  return resolved;
}

} // namespace dewpoint::calibration

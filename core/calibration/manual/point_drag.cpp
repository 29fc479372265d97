// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/point_drag.h"

#include "core/geometry/linear_algebra.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"
#include "core/geometry/rotation_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr double kStepPx = 20.0;     ///< along the way of the pointer
constexpr double kExactPx = 1e-8;    ///< held points stay within this
constexpr double kLongestStep = 0.3; ///< of a change per step: more would be a jump
constexpr double kRank = 1e-5;       ///< smallest singular value over the largest
/// Newton steps.
constexpr int kMostSolverSteps = 30;
/// Of the step along the way, before the drag stops.
constexpr int kMostHalvings = 5;

double missOf(const Camera& camera, const ImageAnchor& anchor) {
  const auto seen = Projector(camera).project(anchor.world);
  return seen ? (*seen - anchor.pixel).norm() : std::numeric_limits<double>::infinity();
}

DragResult finished(const Camera& camera, DragLimit limit, const ImageAnchor& dragged) {
  return {camera, limit, missOf(camera, dragged)};
}

/// Nothing held: in closed form.
DragResult dragFree(const Camera& camera, const ImageAnchor& dragged, DragMode mode) {
  const Eigen::Vector3d point = camera.cameraFromWorld * dragged.world;
  const auto wanted = Unprojector(camera).worldDirection(dragged.pixel);
  if (!wanted || !(point.z() > 0.0)) {
    return finished(camera, DragLimit::OutOfSight, dragged);
  }
  const Eigen::Vector3d ray = camera.cameraFromWorld.linear() * *wanted;
  Camera result = camera;
  if (mode == DragMode::Turn) {
    const Eigen::Matrix3d turn = geometry::rotationBetween(point, ray);
    result.cameraFromWorld.linear() = turn * camera.cameraFromWorld.linear();
    result.cameraFromWorld.translation() = turn * camera.cameraFromWorld.translation();
  } else if (ray.z() > 0.0) {
    result.cameraFromWorld.translation() += ray * (point.z() / ray.z()) - point;
  }
  return finished(result, DragLimit::None, dragged);
}

/// Finds the change of a camera that keeps points at their pixels, from the change before.
class ConstrainedChange {
public:
  using Basis = Eigen::Matrix<double, 7, Eigen::Dynamic>;

  ConstrainedChange(const CameraVariation& change, Basis basis, std::vector<ImageAnchor> exact,
                    std::vector<ImageAnchor> approximate)
      : change_(change), basis_(std::move(basis)), exact_(std::move(exact)),
        approximate_(std::move(approximate)) {}

  Eigen::Index size() const { return basis_.cols(); }
  ChangeVector full(const Eigen::VectorXd& q) const { return basis_ * q; }

  /// With the dragged point at `pixel`; `q` is where to begin and what was found.
  DragLimit solve(const Eigen::Vector2d& pixel, Eigen::VectorXd& q) {
    (approximate_.empty() ? exact_ : approximate_).back().pixel = pixel;
    Eigen::VectorXd at = q;
    for (int k = 0; k < kMostSolverSteps; ++k) {
      const auto error = change_.residuals(full(at), exact_);
      const auto slope = change_.jacobian(full(at), exact_);
      if (!error || !slope) {
        return DragLimit::OutOfSight;
      }
      DragLimit limit = DragLimit::None;
      const Eigen::VectorXd next = approximate_.empty()
                                       ? leastChange(*slope * basis_, *error, at, limit)
                                       : nearest(*slope * basis_, *error, at, limit);
      if (limit != DragLimit::None) {
        return limit;
      }
      const double moved = (next - at).norm();
      at = next;
      if (!at.allFinite() || (at - q).norm() > kLongestStep) {
        return DragLimit::OutOfReach;
      }
      if (moved < 1e-11) {
        break;
      }
    }
    const auto error = change_.residuals(full(at), exact_);
    if (!error || error->cwiseAbs().maxCoeff() > kExactPx) {
      return error ? DragLimit::OutOfReach : DragLimit::OutOfSight;
    }
    q = at;
    return DragLimit::None;
  }

private:
  using Svd = geometry::SingularValues;

  static bool isWeak(const Svd& svd, Eigen::Index rank) {
    return !(svd.values()[rank - 1] > kRank * svd.values()[0]);
  }

  /// Of all that satisfy the linearized constraints, the smallest change from the beginning of the
  /// drag: q = J+ (J q0 - e), the fixed point of which is the least change that satisfies them.
  static Eigen::VectorXd leastChange(const Eigen::MatrixXd& slope, const Eigen::VectorXd& error,
                                     const Eigen::VectorXd& at, DragLimit& limit) {
    const Svd svd(slope, Svd::Vectors::Thin);
    if (isWeak(svd, std::min(slope.rows(), slope.cols()))) {
      limit = DragLimit::OneRay;
      return at;
    }
    return svd.solve(slope * at - error);
  }

  /// A Gauss-Newton step that brings the approximate anchor nearer in what the constraints leave
  /// free.
  Eigen::VectorXd nearest(const Eigen::MatrixXd& slope, const Eigen::VectorXd& error,
                          const Eigen::VectorXd& at, DragLimit& limit) const {
    const Svd svd(slope, Svd::Vectors::Full);
    const auto miss = change_.residuals(full(at), approximate_);
    const auto approximateSlope = change_.jacobian(full(at), approximate_);
    const Eigen::Index rank = slope.rows();
    if (isWeak(svd, rank)) {
      limit = DragLimit::OneRay;
      return at;
    }
    if (!miss || !approximateSlope) {
      limit = DragLimit::OutOfSight;
      return at;
    }
    const Eigen::VectorXd back = -svd.solve(error);
    const Eigen::MatrixXd free = svd.matrixV().rightCols(slope.cols() - rank);
    const Eigen::MatrixXd effect = *approximateSlope * basis_ * free;
    const Svd along(effect, Svd::Vectors::Thin);
    return at + back - free * along.solve(*miss + *approximateSlope * basis_ * back);
  }

  const CameraVariation& change_;
  Basis basis_;
  std::vector<ImageAnchor> exact_;
  std::vector<ImageAnchor> approximate_;
};

/// Along and about the ray of the held point.
ConstrainedChange::Basis aboutRay(const Camera& camera, const ImageAnchor& held) {
  const Eigen::Vector3d ray = (camera.cameraFromWorld * held.world).normalized();
  ConstrainedChange::Basis basis = ConstrainedChange::Basis::Zero(7, 2);
  basis.col(0).head<3>() = ray;
  basis.col(1).segment<3>(3) = ray;
  return basis;
}

/// Follows the pointer from where the point is now to where it should be.
DragResult follow(const Camera& camera, const CameraVariation& change, ConstrainedChange& solver,
                  const Eigen::Vector2d& from, const ImageAnchor& dragged) {
  const double length = (dragged.pixel - from).norm();
  if (length < kExactPx) {
    return finished(camera, DragLimit::None, dragged); // to the bit as it was
  }
  const double step = std::min(1.0, kStepPx / length);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(solver.size());
  double done = 0.0;
  int halvings = 0;
  DragLimit limit = DragLimit::None;
  while (done < 1.0 && halvings <= kMostHalvings) {
    const double next = std::min(1.0, done + step / double(1 << halvings));
    limit = solver.solve(from + next * (dragged.pixel - from), q);
    if (limit == DragLimit::None) {
      done = next;
      halvings = std::max(0, halvings - 1);
    } else {
      ++halvings;
    }
  }
  return finished(done > 0.0 ? change.changedCamera(solver.full(q)) : camera, limit, dragged);
}

} // namespace

DragResult dragPoint(const Camera& camera, const std::vector<ImageAnchor>& held,
                     const ImageAnchor& dragged, const DragSettings& settings) {
  if (held.empty()) {
    return dragFree(camera, dragged, settings.mode);
  }
  if (held.size() > static_cast<std::size_t>(kMaxHeldPoints) ||
      (held.size() == static_cast<std::size_t>(kMaxHeldPoints) && !settings.focalMayChange)) {
    return finished(camera, DragLimit::Fixed, dragged);
  }
  std::vector<ImageAnchor> exact = held;
  exact.push_back(dragged);
  const Projector projector(camera);
  for (ImageAnchor& anchor : exact) {
    const auto seen = projector.project(anchor.world);
    if (!seen) {
      return finished(camera, DragLimit::OutOfSight, dragged);
    }
    anchor.pixel = *seen; // held is what is seen now, not what was seen with another pose
  }
  const Eigen::Vector2d from = exact.back().pixel;
  const CameraVariation change(camera, meanDistance(camera, exact));
  std::vector<ImageAnchor> approximate;
  ConstrainedChange::Basis basis = ConstrainedChange::Basis::Identity(7, 6);
  if (held.size() == 1 && settings.mode == DragMode::Turn) {
    basis = aboutRay(camera, held.front());
    exact.erase(exact.begin()); // that ray keeps the held point by itself
  } else if (held.size() == static_cast<std::size_t>(kMaxHeldPoints)) {
    basis = ConstrainedChange::Basis::Identity(7, 7);
    approximate.push_back(exact.back());
    exact.pop_back();
  }
  ConstrainedChange solver(change, basis, exact, approximate);
  return follow(camera, change, solver, from, dragged);
}

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/position_error.h"

#include "core/calibration/bundle/bundle_cost.h"
#include "core/geometry/linear_algebra.h"
#include "core/geometry/mean_vector.h"
#include "core/geometry/projector.h"
#include "core/geometry/rotation_vector.h"

#include <Eigen/LU>

#include <algorithm>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Radians, of the differences.
constexpr double kAngleStep = 1e-6;
/// Meters, of the differences.
constexpr double kMeterStep = 1e-6;
constexpr double kLensStep = 1e-4; ///< pixels, and of dimensionless numbers a thousandth of it

double stepOf(CameraQuantity quantity) {
  if (quantity <= CameraQuantity::TurnZ) {
    return kAngleStep;
  }
  if (quantity <= CameraQuantity::CenterZ) {
    return kMeterStep;
  }
  return quantity == CameraQuantity::Focal || quantity == CameraQuantity::PrincipalX ||
                 quantity == CameraQuantity::PrincipalY
             ? kLensStep
             : 1e-3 * kLensStep;
}

/// The camera with one of its numbers larger by `step`.
Camera withChange(Camera camera, CameraQuantity quantity, double step) {
  const int index = static_cast<int>(quantity);
  if (index < 3) {
    const Eigen::Vector3d center = camera.center();
    camera.cameraFromWorld.linear() =
        rotationExponential(step * Eigen::Vector3d::Unit(index)) * camera.cameraFromWorld.linear();
    camera.cameraFromWorld.translation() = -camera.cameraFromWorld.linear() * center;
  } else if (index < kPoseSize) {
    const Eigen::Vector3d center = camera.center() + step * Eigen::Vector3d::Unit(index - 3);
    camera.cameraFromWorld.translation() = -camera.cameraFromWorld.linear() * center;
  } else if (quantity != CameraQuantity::TimeOffset) {
    auto lens = lensBlock(camera);
    lens.at(static_cast<std::size_t>(index - kPoseSize)) += step;
    setLens(lens, camera);
  }
  return camera;
}

/// A camera, and it with each of its numbers a little larger.
struct VariedCamera {
  Projector projector;
  std::vector<std::pair<Eigen::Index, Projector>> varied;
  std::vector<double> steps;
};

std::vector<VariedCamera> variedCameras(const BundleResult& result) {
  std::vector<VariedCamera> cameras;
  for (std::size_t c = 0; c < result.cameras.size(); ++c) {
    VariedCamera camera{Projector(result.cameras[c]), {}, {}};
    const auto& columns = result.covariance.columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k].camera == c) {
        const double step = stepOf(columns[k].quantity);
        camera.steps.push_back(step);
        camera.varied.emplace_back(
            static_cast<Eigen::Index>(k),
            Projector(withChange(result.cameras[c], columns[k].quantity, step)));
      }
    }
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

/// Not geometry::isInImage(), which ends at the centers of the last pixels: which positions count
/// is in the accuracies that reports have stated.
bool isOnPixels(const Intrinsics& image, const Eigen::Vector2d& pixel) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < image.width &&
         pixel.y() < image.height;
}

/// Adds one place to the errors, if two cameras see it.
void addPosition(const std::vector<VariedCamera>& cameras, const Eigen::Vector3d& position,
                 PositionErrors& errors, std::vector<Eigen::MatrixXd>& rows, Eigen::Index columns) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(3, columns);
  int seeing = 0;
  for (const VariedCamera& camera : cameras) {
    const auto here = camera.projector.project(position);
    if (!here || !isOnPixels(camera.projector.intrinsics(), *here)) {
      continue;
    }
    Eigen::Matrix<double, 2, 3> byPosition;
    for (int axis = 0; axis < 3; ++axis) {
      const auto there =
          camera.projector.project(position + kMeterStep * Eigen::Vector3d::Unit(axis));
      byPosition.col(axis) = there ? Eigen::Vector2d((*there - *here) / kMeterStep)
                                   : Eigen::Vector2d(Eigen::Vector2d::Zero());
    }
    information += byPosition.transpose() * byPosition;
    for (std::size_t k = 0; k < camera.varied.size(); ++k) {
      if (const auto there = camera.varied[k].second.project(position)) {
        pull.col(camera.varied[k].first) -=
            byPosition.transpose() * (*there - *here) / camera.steps[k];
      }
    }
    ++seeing;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(information);
  if (seeing < 2 || !solver.isInvertible()) {
    return;
  }
  errors.positions.push_back(position);
  errors.noiseCovariances.emplace_back(solver.inverse());
  rows.emplace_back(solver.solve(pull));
}

/// How positions move with the six rigid motions about `middle`, and with a change of size.
Eigen::MatrixXd rigidMotions(const std::vector<Eigen::Vector3d>& positions,
                             const Eigen::Vector3d& middle, bool sizeToo) {
  Eigen::MatrixXd motions(static_cast<Eigen::Index>(3 * positions.size()), sizeToo ? 7 : 6);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Eigen::Vector3d arm = positions[i] - middle;
    auto rows = motions.middleRows<3>(static_cast<Eigen::Index>(3 * i));
    rows.leftCols<3>().setIdentity();
    for (int axis = 0; axis < 3; ++axis) {
      rows.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(arm);
    }
    if (sizeToo) {
      rows.col(6) = arm;
    }
  }
  return motions;
}

} // namespace

std::vector<Eigen::Vector3d> observedPositions(const BundleProblem& problem,
                                               const BundleResult& result) {
  std::vector<Eigen::Vector3d> positions;
  for (const BundleState& state : result.states) {
    if (!state.isPositionKnown) {
      continue;
    }
    const BundleBody& body = problem.bodies[state.body];
    if (body.kind == BundleBody::Kind::Board) {
      for (const std::size_t corner : {std::size_t{0}, body.points.size() - 1}) {
        positions.push_back(state.worldFromBoard * body.points[corner]);
      }
      continue;
    }
    positions.push_back(state.ends[0]);
    if (body.kind == BundleBody::Kind::Stick) {
      positions.push_back(state.ends[1]);
    }
  }
  return positions;
}

PositionErrors propagateToPositions(const BundleProblem& problem, const BundleResult& result,
                                    std::size_t most) {
  return propagateErrorsTo(chooseEvenly(observedPositions(problem, result), most), result);
}

PositionErrors propagateErrorsTo(const std::vector<Eigen::Vector3d>& positions,
                                 const BundleResult& result) {
  PositionErrors errors;
  const auto columns = static_cast<Eigen::Index>(result.covariance.columns.size());
  const auto cameras = variedCameras(result);
  std::vector<Eigen::MatrixXd> rows;
  for (const Eigen::Vector3d& position : positions) {
    addPosition(cameras, position, errors, rows, columns);
  }
  errors.cameraJacobian.resize(static_cast<Eigen::Index>(3 * rows.size()), columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    errors.cameraJacobian.middleRows<3>(static_cast<Eigen::Index>(3 * i)) = rows[i];
  }
  return errors;
}

std::vector<Eigen::Vector3d> chooseEvenly(const std::vector<Eigen::Vector3d>& all,
                                          std::size_t most) {
  std::vector<Eigen::Vector3d> chosen;
  const std::size_t count = std::min(most, all.size());
  for (std::size_t i = 0; i < count; ++i) {
    chosen.push_back(all[i * all.size() / count]);
  }
  return chosen;
}

Eigen::MatrixXd removeRigidMotion(const std::vector<Eigen::Vector3d>& positions,
                                  const Eigen::MatrixXd& errors, bool sizeToo) {
  const Eigen::MatrixXd motions = rigidMotions(positions, meanVector(positions), sizeToo);
  return errors - motions * geometry::leastSquares(motions, errors);
}

Eigen::MatrixXd removeRigidMotionOf(const std::vector<Eigen::Vector3d>& positions,
                                    const Eigen::MatrixXd& errors, bool sizeToo,
                                    const std::vector<Eigen::Vector3d>& others,
                                    const Eigen::MatrixXd& errorsOfOthers) {
  const Eigen::Vector3d middle = meanVector(positions);
  const Eigen::MatrixXd motions = rigidMotions(positions, middle, sizeToo);
  return errorsOfOthers -
         rigidMotions(others, middle, sizeToo) * geometry::leastSquares(motions, errors);
}

Eigen::RowVectorXd sizeChange(const std::vector<Eigen::Vector3d>& positions,
                              const Eigen::MatrixXd& errors) {
  const Eigen::Vector3d middle = meanVector(positions);
  Eigen::VectorXd arms(errors.rows());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    arms.segment<3>(static_cast<Eigen::Index>(3 * i)) = positions[i] - middle;
  }
  return arms.transpose() * errors / arms.squaredNorm();
}

Eigen::VectorXd cameraParameterDifference(const std::vector<CameraParameterColumn>& columns,
                                          const BundleResult& from, const BundleResult& to) {
  Eigen::VectorXd difference(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Camera& before = from.cameras[columns[k].camera];
    const Camera& after = to.cameras[columns[k].camera];
    const int index = static_cast<int>(columns[k].quantity);
    double& value = difference[static_cast<Eigen::Index>(k)];
    if (index < 3) {
      value = vectorFromRotation(after.cameraFromWorld.linear() *
                                 before.cameraFromWorld.linear().transpose())[index];
    } else if (index < kPoseSize) {
      value = after.center()[index - 3] - before.center()[index - 3];
    } else if (columns[k].quantity == CameraQuantity::TimeOffset) {
      value = to.timeOffsets[columns[k].camera] - from.timeOffsets[columns[k].camera];
    } else {
      const auto entry = static_cast<std::size_t>(index - kPoseSize);
      value = lensBlock(after)[entry] - lensBlock(before)[entry];
    }
  }
  return difference;
}

} // namespace dewpoint::calibration

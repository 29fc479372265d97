// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle/bundle_covariance.h"

#include "core/geometry/linear_algebra.h"

#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>

namespace dewpoint::calibration {
namespace {

/// Directions weaker than this, against the strongest in units of the columns' own precision, are
/// not determined.
constexpr double kLeastShare = 1e-13;

/// Root of the summed variances of several quantities of a camera.
double spread(const BundleCovariance& covariance, std::size_t camera, CameraQuantity from,
              CameraQuantity to) {
  double variance = 0.0;
  for (std::size_t k = 0; k < covariance.columns.size(); ++k) {
    const CameraParameterColumn& column = covariance.columns[k];
    if (column.camera == camera && column.quantity >= from && column.quantity <= to) {
      const auto at = static_cast<Eigen::Index>(k);
      variance += covariance.matrix(at, at);
    }
  }
  return std::sqrt(variance);
}

} // namespace

std::string quantityName(CameraQuantity quantity) {
  static constexpr std::array<const char*, 19> kNames{
      "turn x", "turn y", "turn z", "x",  "y",  "z",  "focal", "aspect", "center x", "center y",
      "k1",     "k2",     "p1",     "p2", "k3", "k4", "k5",    "k6",     "offset"};
  return kNames.at(static_cast<std::size_t>(quantity));
}

double centerSigma(const BundleCovariance& covariance, std::size_t camera) {
  return spread(covariance, camera, CameraQuantity::CenterX, CameraQuantity::CenterZ);
}

double rotationSigma(const BundleCovariance& covariance, std::size_t camera) {
  return spread(covariance, camera, CameraQuantity::TurnX, CameraQuantity::TurnZ);
}

std::optional<Eigen::MatrixXd> reducedCovariance(const Eigen::SparseMatrix<double>& jacobian,
                                                 Eigen::Index cameraColumns,
                                                 int gaugeFreedomCount) {
  const Eigen::Index others = jacobian.cols() - cameraColumns;
  const Eigen::SparseMatrix<double> cameras = jacobian.leftCols(cameraColumns);
  Eigen::MatrixXd information = Eigen::MatrixXd(cameras.transpose() * cameras);
  if (others > 0) {
    const Eigen::SparseMatrix<double> bodies = jacobian.rightCols(others);
    const Eigen::SparseMatrix<double> own = bodies.transpose() * bodies;
    const Eigen::MatrixXd cross = Eigen::MatrixXd(bodies.transpose() * cameras);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(own);
    if (solver.info() != Eigen::Success) {
      return std::nullopt;
    }
    information -= cross.transpose() * solver.solve(cross);
  }
  const Eigen::VectorXd scale = Eigen::VectorXd((cameras.transpose() * cameras)
                                                    .eval()
                                                    .diagonal()
                                                    .cwiseMax(1e-300)
                                                    .cwiseSqrt()
                                                    .cwiseInverse());
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const auto eigen = geometry::symmetricEigen(0.5 * (scaled + scaled.transpose()));
  if (!eigen.hasConverged || gaugeFreedomCount > cameraColumns) {
    return std::nullopt;
  }
  const Eigen::Index kept = cameraColumns - gaugeFreedomCount;
  const Eigen::VectorXd values = eigen.eigenvalues.tail(kept);
  if (kept > 0 && !(values[0] > kLeastShare * values[kept - 1])) {
    return std::nullopt;
  }
  const Eigen::MatrixXd directions = scale.asDiagonal() * eigen.eigenvectors.rightCols(kept);
  return directions * values.cwiseInverse().asDiagonal() * directions.transpose();
}

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Names and values of the camera parameters that a calibration estimates; see IntrinsicsModel.
class IntrinsicsParameters {
public:
  IntrinsicsParameters(IntrinsicsModel model, bool squarePixels);

  const std::vector<std::string>& names() const { return names_; }
  /// Parameter values of a camera, in the order of names().
  Eigen::VectorXd of(const Camera& camera) const;
  /// Returns the camera with these parameter values.
  Camera applied(Camera camera, const Eigen::VectorXd& values) const;
  /// Step sizes for numeric derivatives.
  Eigen::VectorXd steps(const Camera& camera) const;

private:
  std::vector<std::string> names_;
  bool squarePixels_;
  int coefficients_;
};

/// Covariance of a camera's intrinsics when they are estimated from views together with the board
/// pose of each view: the inverse of the normal matrix with the poses eliminated (Triggs et al.
/// 2000, section 6.1), times the variance of the residuals. Empty if the views do not determine the
/// intrinsics.
Eigen::MatrixXd intrinsicsCovariance(const BoardDescription& board, const Camera& camera,
                                     const IntrinsicsParameters& parameters,
                                     const std::vector<ViewFit>& views);

/// Standard deviation, in pixels, of the projection of a ray: the largest of 9x9 points over the
/// image. Errors that a rotation of the camera would compensate are excluded, because poses are
/// estimated later (the idea of mrcal's projection uncertainty).
double projectionSigma(const Camera& camera, const IntrinsicsParameters& parameters,
                       const Eigen::MatrixXd& covariance);

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Names and values of the camera parameters that are estimated by a calibration; see
/// IntrinsicsModel.
class IntrinsicsParameters {
public:
  IntrinsicsParameters(IntrinsicsModel model, bool squarePixels);

  const std::vector<std::string>& names() const { return names_; }
  /// Returns the parameter values of a camera, in the order of names().
  Eigen::VectorXd of(const Camera& camera) const;
  /// Returns the camera with these parameter values.
  Camera applied(Camera camera, const Eigen::VectorXd& values) const;
  /// Returns the step sizes for numeric derivatives.
  Eigen::VectorXd steps(const Camera& camera) const;

private:
  std::vector<std::string> names_;
  bool squarePixels_;
  int coefficients_;
};

/// Returns the covariance of a camera's intrinsics. They must have been estimated from `views`,
/// jointly with the pose of the board in each view. The covariance is the inverse of the normal
/// matrix with the poses eliminated (Triggs et al. 2000, section 6.1), times the variance of the
/// residuals. Returns an empty matrix if the views do not determine the intrinsics.
Eigen::MatrixXd intrinsicsCovariance(const BoardDescription& board, const Camera& camera,
                                     const IntrinsicsParameters& parameters,
                                     const std::vector<ViewFit>& views);

/// Returns the standard deviation, in pixels, of the projection of a ray: the largest one among 9 x
/// 9 points across the image. Errors that a rotation of the camera could compensate are excluded,
/// because the pose of the camera is estimated later (following mrcal's projection uncertainty).
double projectionSigma(const Camera& camera, const IntrinsicsParameters& parameters,
                       const Eigen::MatrixXd& covariance);

} // namespace dewpoint::calibration

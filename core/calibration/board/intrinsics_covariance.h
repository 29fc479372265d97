// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/intrinsics_from_board.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// The numbers of a camera that a calibration estimates, by name: see IntrinsicsModel.
class IntrinsicsParameters {
public:
  IntrinsicsParameters(IntrinsicsModel model, bool squarePixels);

  const std::vector<std::string>& names() const { return names_; }
  Eigen::VectorXd of(const Camera& camera) const;
  /// The camera with these numbers in place of its own.
  Camera applied(Camera camera, const Eigen::VectorXd& values) const;
  /// Steps for numeric derivatives.
  Eigen::VectorXd steps(const Camera& camera) const;

private:
  std::vector<std::string> names_;
  bool squarePixels_;
  int coefficients_;
};

/// Covariance of a camera's intrinsics estimated from views together with the pose of each: the
/// inverse of the normal matrix with the poses eliminated (Triggs et al. 2000, section 6.1), times
/// the variance of the residuals. Empty when the views do not determine them.
Eigen::MatrixXd intrinsicsCovariance(const BoardDescription& board, const Camera& camera,
                                     const IntrinsicsParameters& parameters,
                                     const std::vector<ViewFit>& views);

/// Standard deviation, in pixels, of the image of a ray, largest of 9x9 points over the image: what
/// a turn of the camera would compensate is left aside, since poses are estimated later (the idea
/// of mrcal's projection uncertainty).
double projectionSigma(const Camera& camera, const IntrinsicsParameters& parameters,
                       const Eigen::MatrixXd& covariance);

} // namespace dewpoint::calibration

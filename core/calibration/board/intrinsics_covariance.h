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

/// Returns what each used view says about the intrinsics, in the order of instants.
std::vector<LensEvidence> lensEvidence(const BoardDescription& board, const Camera& camera,
                                       const IntrinsicsParameters& parameters,
                                       const std::vector<ViewFit>& views);

/// Returns the change of the parameters (in the order of IntrinsicsResult::parameters) if the views
/// with instants from `first` to before `end` are left out, to first order. 0 if the other views do
/// not determine the intrinsics.
Eigen::VectorXd lensChangeWithout(const std::vector<LensEvidence>& evidence, std::int64_t first,
                                  std::int64_t end);

/// Returns the camera of a result as it would be without the views with instants from `first` to
/// before `end`, to first order.
Camera lensWithout(const IntrinsicsResult& result, std::int64_t first, std::int64_t end);

/// Returns the covariance of the intrinsics that the views themselves show: the scatter of ten
/// results, each without a block of neighboring views (delete-a-group jackknife, Kott 2001), for
/// Student's t instead of the normal distribution. It contains errors that the corners of a view,
/// or neighboring views, share. Returns an empty matrix if there are fewer than four views.
Eigen::MatrixXd lensJackknife(const std::vector<LensEvidence>& evidence);

/// Returns `covariance` with each parameter's variance increased to that of `found`, if it is
/// smaller. The correlations stay as they are.
Eigen::MatrixXd widenedCovariance(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& found);

/// Returns the standard deviation, in pixels, of the projection of a ray: the largest one among 9 x
/// 9 points across the image. Errors that a rotation of the camera could compensate are excluded,
/// because the pose of the camera is estimated later (following mrcal's projection uncertainty).
double projectionSigma(const Camera& camera, const IntrinsicsParameters& parameters,
                       const Eigen::MatrixXd& covariance);

} // namespace dewpoint::calibration

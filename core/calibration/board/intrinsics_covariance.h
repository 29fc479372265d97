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
  Eigen::VectorXd valuesOf(const Camera& camera) const;
  /// Returns the camera with these parameter values.
  Camera withValues(Camera camera, const Eigen::VectorXd& values) const;
  /// Returns a step size for each parameter, in the order of names(), for numeric derivatives.
  Eigen::VectorXd stepSizes(const Camera& camera) const;

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

/// Returns the normal equations of each used view, which contain its information about the
/// intrinsics, in ascending order of instants.
std::vector<ViewNormalEquations> normalEquationsOfViews(const BoardDescription& board,
                                                        const Camera& camera,
                                                        const IntrinsicsParameters& parameters,
                                                        const std::vector<ViewFit>& views);

/// Returns how much the estimated intrinsics change, to first order, if the views with instants
/// from `first` to before `end` are left out. `evidence` contains the normal equations of all
/// views. The order is that of IntrinsicsResult::parameters. All changes are 0 if the remaining
/// views do not determine the intrinsics.
Eigen::VectorXd lensChangeWithoutViews(const std::vector<ViewNormalEquations>& evidence,
                                       std::int64_t first, std::int64_t end);

/// Returns the camera that the calibration `result` would give without the views with instants from
/// `first` to before `end`; computed to first order.
Camera lensWithoutViews(const IntrinsicsResult& result, std::int64_t first, std::int64_t end);

/// Returns the covariance of the intrinsics, estimated from the scatter of up to ten results
/// computed from `evidence`, the normal equations of all views. Each result leaves out one block of
/// neighboring views (delete-a-group jackknife, Kott 2001). The scatter includes errors that the
/// corners of a view, or neighboring views, share. The covariance is enlarged so that 1.96 standard
/// deviations bound 95 % of the errors despite the small number of results (Student's t). Returns
/// an empty matrix if there are fewer than four views.
Eigen::MatrixXd lensJackknifeCovariance(const std::vector<ViewNormalEquations>& evidence);

/// Returns `covariance` with each variance replaced by the variance in `found`, if the latter is
/// larger. The correlations do not change.
Eigen::MatrixXd widenedCovariance(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& found);

/// Returns the standard deviation, in pixels, of the projection of a ray: the largest one among 9 x
/// 9 points across the image. Errors that a rotation of the camera would compensate are excluded,
/// because the pose of the camera is estimated later (following mrcal's projection uncertainty).
double projectionSigma(const Camera& camera, const IntrinsicsParameters& parameters,
                       const Eigen::MatrixXd& covariance);

} // namespace dewpoint::calibration

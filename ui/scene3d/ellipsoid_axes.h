// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vtkActor.h>

#include <optional>

namespace dewpoint::ui {

/// Principal axes of an ellipsoid (columns of `directions`) and the corresponding eigenvalues. The
/// axes are right-handed, because a mirrored sphere would be lit from inside.
struct EllipsoidAxes {
  Eigen::Matrix3d directions;
  Eigen::Vector3d eigenvalues;
};

/// Returns the principal axes of the ellipsoid that a symmetric matrix (such as a covariance)
/// describes, or nothing if no eigenvalue is positive.
std::optional<EllipsoidAxes> ellipsoidAxesOf(const Eigen::Matrix3d& matrix);

/// Rotates a VTK actor so that its axes point along the columns of `directions`, which must be
/// right-handed.
void setOrientation(vtkActor* actor, const Eigen::Matrix3d& directions);

} // namespace dewpoint::ui

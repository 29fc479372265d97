// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vtkActor.h>

#include <optional>

namespace dewpoint::ui {

/// The axes of an ellipsoid, right-handed (a mirrored ball would be lit from inside), and the
/// eigenvalues along them.
struct EllipsoidAxes {
  Eigen::Matrix3d directions;
  Eigen::Vector3d values;
};

/// Of a symmetric matrix; nothing where no eigenvalue is above 0.
std::optional<EllipsoidAxes> axesOf(const Eigen::Matrix3d& matrix);

/// Turns an actor so that its axes point along these, which are right-handed.
void turn(vtkActor* actor, const Eigen::Matrix3d& directions);

} // namespace dewpoint::ui

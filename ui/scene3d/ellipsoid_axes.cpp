// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/ellipsoid_axes.h"

#include <Eigen/Eigenvalues>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkTransform.h>

#include <array>

namespace dewpoint::ui {

std::optional<EllipsoidAxes> ellipsoidAxesOf(const Eigen::Matrix3d& matrix) {
  if (!matrix.allFinite()) {
    return std::nullopt;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(0.5 * (matrix + matrix.transpose()));
  if (solver.info() != Eigen::Success || solver.eigenvalues().maxCoeff() <= 0.0) {
    return std::nullopt;
  }
  EllipsoidAxes axes{solver.eigenvectors(), solver.eigenvalues()};
  if (axes.directions.determinant() < 0.0) {
    axes.directions.col(0) *= -1.0;
  }
  return axes;
}

void setOrientation(vtkActor* actor, const Eigen::Matrix3d& directions) {
  vtkNew<vtkMatrix4x4> pose;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      pose->SetElement(row, column, directions(row, column));
    }
  }
  std::array<double, 3> angles{};
  vtkTransform::GetOrientation(angles.data(), pose);
  actor->SetOrientation(angles.data());
}

} // namespace dewpoint::ui

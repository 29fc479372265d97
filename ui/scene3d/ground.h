// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_actors.h"

#include <Eigen/Geometry>
#include <vtkPolyData.h>

#include <array>
#include <string>
#include <vector>

namespace dewpoint::ui {

/// Floor z = 0: a faint plane, lines every 0.1 m or 1 m, numbers in meters along two edges, and the
/// axes at the origin. In the views from the front and from the side, in which the floor is only a
/// line, a wall in the x-z or y-z plane replaces it.
class Ground {
public:
  explicit Ground(vtkRenderer* renderer);
  /// Sets the rectangle to cover, rounded outward to whole grid steps, and the room height. The
  /// plane is drawn below `lowest`, so that it hides nothing from above even if z = 0 is not the
  /// floor. All arguments are in meters.
  void cover(const Eigen::AlignedBox2d& extent, double height, double lowest = 0.0);
  /// Sets the decimal separator for the numbers.
  void setDecimalPoint(const std::string& sign);
  void setPalette(const ScenePalette& palette);
  void prepareRendering(const ScreenScale& scale);
  /// Appends the approximate areas of the numbers and axis names in the rendered image: device
  /// pixels to the right of and above the center.
  void appendTextAreas(const ScreenScale& scale, std::vector<Eigen::AlignedBox2d>& places) const;
  /// Returns the rectangle covered by the floor after rounding, in meters.
  const Eigen::AlignedBox2d& extent() const { return extent_; }

private:
  void drawPlane();
  void drawLines();
  void drawNumbers();
  /// Draws fewer numbers along an axis if they would lie on each other.
  void thinNumbers(const ScreenScale& scale);
  void drawWalls();
  void drawAxes();

  vtkNew<vtkPolyData> planeData_;
  vtkNew<vtkPolyData> minorData_;
  vtkNew<vtkPolyData> majorData_;
  vtkNew<vtkPolyData> wallMinorData_[2];
  vtkNew<vtkPolyData> wallMajorData_[2];
  vtkNew<vtkPolyData> axisData_[3];
  vtkSmartPointer<vtkActor> plane_;
  vtkSmartPointer<vtkActor> minor_;
  vtkSmartPointer<vtkActor> major_;
  vtkSmartPointer<vtkActor> wallMinor_[2]; ///< the wall along x, and the wall along y
  vtkSmartPointer<vtkActor> wallMajor_[2];
  vtkSmartPointer<vtkActor> axes_[3];
  SceneLabels numbers_[3]; ///< along x, along y, and along z on a wall
  SceneLabels names_[3];   ///< axis names
  Eigen::AlignedBox2d extent_;
  double height_ = 0.0;
  double planeHeight_ = 0.0;
  double majorStep_ = 1.0;
  double minorStep_ = 0.1;
  double numberStep_ = 1.0;                               ///< at least, meters
  Eigen::Vector3d numberSteps_ = Eigen::Vector3d::Ones(); ///< as drawn, along each axis
  /// Along each axis, whether the last number is so near that the one before it is left out.
  std::array<bool, 3> isUnitCrowded_{};
  bool isFromSide_ = false; ///< then the numbers along y are below the floor
  std::string decimalPoint_ = ".";
};

} // namespace dewpoint::ui

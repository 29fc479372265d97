// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/scene3d/person_actors.h"
#include "ui/scene3d/scene_actors.h"

#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <optional>

namespace dewpoint::ui {

/// One target: particles, estimate with the ellipsoid that holds 95 % of the belief, the particle
/// of highest weight, tail, truth, and the plumb line to the floor that shows its height.
class TargetActors {
public:
  TargetActors(vtkRenderer* renderer, std::size_t index);
  ~TargetActors();
  TargetActors(const TargetActors&) = delete;
  TargetActors& operator=(const TargetActors&) = delete;

  void show(const TargetSnapshot& target);
  /// A chosen person stands out.
  void setChosen(bool chosen) { person_.setChosen(chosen); }
  /// Whether the particle of highest weight is marked; not at first.
  void setBestShown(bool shown);
  void setPalette(const ScenePalette& palette);
  void prepareFrame(const ScreenScale& scale);

private:
  void showParticles(const TargetSnapshot& target);
  void showEstimate(const TargetSnapshot& target);
  /// The shape of the target, at the origin.
  void showBody(const TargetSnapshot& target);
  void showEllipsoid(const Eigen::Matrix3d& covariance);
  void showTail(const TargetSnapshot& target);
  void showTruth(const TargetSnapshot& target);
  void showBest();
  void colorParticles();
  void drawTruth(const ScreenScale& scale);
  void drawBest(const ScreenScale& scale);

  vtkRenderer* renderer_;
  std::size_t index_;
  SceneColor color_;
  ScenePalette palette_;
  std::vector<float> brightness_; ///< per drawn particle, 0 to 1
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d truth_ = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> best_; ///< particle of highest weight
  bool bestShown_ = false;
  double radius_ = 0.0;
  /// Semi-axes of what is no ball, meters; all are the radius of a ball.
  Eigen::Vector3d semiAxes_ = Eigen::Vector3d::Zero();
  double cloudReach_ = 0.0; ///< from the mean to the rim of the ellipsoid, meters

  vtkNew<vtkFloatArray> positions_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> cloudData_;
  vtkNew<vtkPointGaussianMapper> cloudMapper_;
  vtkNew<vtkActor> cloud_;
  vtkNew<vtkMatrix4x4> ellipsoidPose_;
  vtkNew<vtkPolyData> ringData_;
  vtkNew<vtkPolyData> tailData_;
  vtkNew<vtkPolyData> plumbData_;
  vtkNew<vtkPolyData> truthData_;
  vtkNew<vtkPolyData> bestData_;
  vtkSmartPointer<vtkActor> sphere_;
  vtkSmartPointer<vtkActor> halo_;
  vtkSmartPointer<vtkActor> ellipsoid_;
  vtkSmartPointer<vtkActor> rings_;
  vtkSmartPointer<vtkActor> tail_;
  vtkSmartPointer<vtkActor> plumb_;
  vtkSmartPointer<vtkActor> truthMark_;
  vtkSmartPointer<vtkActor> bestMark_;
  PersonActors person_;
};

} // namespace dewpoint::ui

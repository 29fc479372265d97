// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/sight_lines.h"
#include "core/session/run/snapshot.h"
#include "ui/scene3d/fading_line.h"
#include "ui/scene3d/floor_shadow.h"
#include "ui/scene3d/glass_body.h"
#include "ui/scene3d/particle_cloud.h"
#include "ui/scene3d/person_actors.h"
#include "ui/scene3d/scene_actors.h"
#include "ui/scene3d/wire_actor.h"

#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>

#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::ui {

/// One target: a body of glass with the particles in it, the ellipsoid that holds 95 % of the
/// belief as rings, the particle of highest weight, tail, truth, lines of sight, the way of the
/// mean, and the shadow on the floor. What is added later lies over what was added before.
class TargetActors {
public:
  explicit TargetActors(vtkRenderer* renderer);
  ~TargetActors();
  TargetActors(const TargetActors&) = delete;
  TargetActors& operator=(const TargetActors&) = delete;

  void show(const TargetSnapshot& target);
  /// Empty: none.
  void showSights(const std::vector<SightLine>& lines);
  /// The way of the mean, oldest first, meters; empty: none.
  void showPath(const std::vector<Eigen::Vector3d>& path) { path_.show(path); }
  /// A chosen person stands out.
  void setChosen(bool chosen);
  /// Whether the particle of highest weight is marked; not at first.
  void setBestShown(bool shown);
  void setColors(const SceneColor& color, const ScenePalette& palette, bool dark);
  const SceneColor& color() const { return color_; }
  void prepareFrame(const ScreenScale& scale);

private:
  void showPerson(const PersonShape* shape);
  void showEstimate(const TargetSnapshot& target);
  /// The shape of the target, at the origin.
  void showBody(const TargetSnapshot& target);
  void showEllipsoid(const Eigen::Matrix3d& covariance);
  void showTruth(const TargetSnapshot& target);
  void showBest();
  void paintBody();
  void placeBody(const ScreenScale& scale);
  void drawTruth(const ScreenScale& scale);
  void drawBest(const ScreenScale& scale);

  vtkRenderer* renderer_;
  SceneColor color_ = SceneColor::Zero();
  ScenePalette palette_;
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d truth_ = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> best_; ///< particle of highest weight
  bool bestShown_ = false;
  bool held_ = false;
  bool chosen_ = false;
  double radius_ = 0.0;
  /// Semi-axes of what is no ball, meters; all are the radius of a ball.
  Eigen::Vector3d semiAxes_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d directions_ = Eigen::Matrix3d::Identity(); ///< of the semi-axes
  double cloudReach_ = 0.0; ///< from the mean to the rim of the ellipsoid, meters

  // In the order in which they are drawn.
  FloorShadow shadow_;
  WireActor seen_;   ///< lines of sight
  WireActor hidden_; ///< those of cameras that do not see it, broken
  FadingLine tail_;
  FadingLine path_;
  GlassBody body_;
  vtkNew<vtkMatrix4x4> ellipsoidPose_;
  vtkNew<vtkPolyData> ringData_;
  vtkSmartPointer<vtkActor> rings_;
  ParticleCloud cloud_;
  GlassBody rim_;
  vtkNew<vtkPolyData> truthData_;
  vtkNew<vtkPolyData> bestData_;
  vtkSmartPointer<vtkActor> truthMark_;
  vtkSmartPointer<vtkActor> bestMark_;
  std::unique_ptr<PersonActors> person_; ///< made for the first shape: most targets have none
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/sight_lines.h"
#include "core/session/snapshot/snapshot.h"
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

/// Actors for one target: a glass body with the particles inside, the 95 % ellipsoid as rings, the
/// highest-weight particle, tail (recent path), ground truth, lines of sight, path of the mean, and
/// shadow on the floor. Parts added later cover those added earlier.
class TargetActors {
public:
  explicit TargetActors(vtkRenderer* renderer);
  ~TargetActors();
  TargetActors(const TargetActors&) = delete;
  TargetActors& operator=(const TargetActors&) = delete;

  void show(const TargetSnapshot& target);
  /// Shows these lines of sight and hides all others.
  void showLinesOfSight(const std::vector<SightLine>& lines);
  /// Shows the path of the mean, oldest first, in meters. An empty path is not shown.
  void showPath(const std::vector<Eigen::Vector3d>& path) { path_.show(path); }
  /// Sets whether the target is selected. A selected person is highlighted; this has no effect for
  /// other targets.
  void setChosen(bool chosen);
  /// Sets whether the highest-weight particle is marked; off by default.
  void setBestParticleShown(bool shown);
  void setColors(const SceneColor& color, const ScenePalette& palette, bool dark);
  const SceneColor& color() const { return color_; }
  void prepareRendering(const ScreenScale& scale);

private:
  void showPerson(const PersonShape* shape);
  void showEstimate(const TargetSnapshot& target);
  /// Shows the target's shape, placed at the origin.
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
  std::optional<Eigen::Vector3d> best_; ///< highest-weight particle, meters
  bool bestShown_ = false;
  bool held_ = false;
  bool chosen_ = false;
  double radius_ = 0.0;
  /// Semi-axes of the shape, meters. For a ball, all three equal the radius.
  Eigen::Vector3d semiAxes_ = Eigen::Vector3d::Zero();
  /// Directions of the semi-axes (columns).
  Eigen::Matrix3d directions_ = Eigen::Matrix3d::Identity();
  double cloudRadius_ = 0.0; ///< distance from the mean to the surface of the ellipsoid, meters

  // Parts in drawing order.
  FloorShadow shadow_;
  WireActor seen_;   ///< lines of sight of cameras that see the target
  WireActor hidden_; ///< dashed lines of sight of cameras that do not see it
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
  /// Created when the first shape is shown, because most targets have none.
  std::unique_ptr<PersonActors> person_;
};

} // namespace dewpoint::ui

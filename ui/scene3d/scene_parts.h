// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/display_colors.h"
#include "ui/scene3d/camera_frusta.h"
#include "ui/scene3d/frustum_images.h"
#include "ui/scene3d/ground.h"
#include "ui/scene3d/map_actor.h"
#include "ui/scene3d/mean_path.h"
#include "ui/scene3d/ordered_renderer.h"
#include "ui/scene3d/scene3d.h"
#include "ui/scene3d/selected_range_actor.h"
#include "ui/scene3d/target_actors.h"
#include "ui/scene3d/wire_actor.h"

#include <vtkCamera.h>
#include <vtkCullerCollection.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace dewpoint::ui {

/// Parts of a Scene3d, and the functions that fit the view to these parts.
class SceneParts {
public:
  using View = Scene3d::View;
  // Thinner than targets and tails, because these lines are less important.
  static constexpr double kVolumeLineWidthPx = 1.2; ///< logical pixels
  static constexpr double kLineOfSightLineWidthPx = 1.6;
  /// Maximum number of targets that are drawn in full. For further targets, only the mean is drawn:
  /// a viewer cannot distinguish that many, and drawing thousands of clouds would block the window.
  static constexpr std::size_t kMaxDetailedTargets = 100;

  SceneParts()
      : ground(renderer), frustumImages(renderer), frusta(renderer), plannedFrusta(renderer),
        map(renderer), volume(renderer, kVolumeLineWidthPx),
        lineOfSight(renderer, kLineOfSightLineWidthPx), selectedRange(renderer),
        undetailedTargetMeans(renderer) {
    renderer->SetActiveCamera(camera);
    // Cullers need bounds, which a cloud of bare points does not have.
    renderer->GetCullers()->RemoveAllItems();
  }

  const ScenePalette& palette() const { return scenePalette(isDark); }
  ScenePalette plannedPalette() const;
  double rigSize() const { return rigBox.isEmpty() ? 2.0 : rigBox.diagonal().norm(); }
  /// Returns the length of the viewing pyramids in meters. They are longer if they carry images, so
  /// that the images are recognizable.
  double frustumLength() const {
    return showsImages ? std::clamp(0.25 * rigSize(), 0.1, 2.0)
                       : std::clamp(0.09 * rigSize(), 0.05, 1.0);
  }
  void applyPalette();
  /// Updates the colors of all targets. Call it after a target color or the palette of the scene
  /// has changed.
  void applyTargetColors();
  void showRig(const std::shared_ptr<const CameraRig>& shown);
  void includeInContent(const TrackSnapshot& snapshot);
  void showUndetailedTargetMeans(const TrackSnapshot& snapshot);
  void coverGround();
  Eigen::AlignedBox3d sceneBox() const; ///< box around the floor and the content, meters
  void fitView();
  void keepUpright();
  void updateClippingRange();
  void updateScale();

  vtkNew<OrderedRenderer> renderer;
  vtkNew<vtkCamera> camera;
  Ground ground;
  FrustumImages frustumImages; ///< drawn first; other parts are drawn over it
  CameraFrusta frusta;
  CameraFrusta plannedFrusta;
  MapActor map;
  WireActor volume;                    ///< volume of interest
  WireActor lineOfSight;               ///< camera line of sight
  SelectedRangeActor selectedRange;    ///< drawn before the targets, which cover it
  ParticleCloud undetailedTargetMeans; ///< means of the targets beyond `kMaxDetailedTargets`
  std::vector<std::unique_ptr<TargetActors>> targets;
  std::vector<DisplayColorSource> colorSources; ///< what determines the color of each target
  MeanPath meanPath;
  std::shared_ptr<const CameraRig> rig;
  std::shared_ptr<const CameraRig>
      rigFittedToView; ///< last rig with cameras that the view was fitted to
  /// Box around the cameras and what they look at, meters; empty without a rig.
  Eigen::AlignedBox3d rigBox;
  Eigen::AlignedBox3d contentBox; ///< box around everything shown since the rig was set, meters
  View view = View::Free;
  bool isDark = false;
  int chosenTarget = -1;
  bool showsBestParticle = false;
  bool showsRays = true;
  bool showsImages = false;
  bool isViewMovedByUser = false; ///< whether the user has moved the view
  bool isFramingPending = true;
  int viewportWidth = 0;
  int viewportHeight = 0;
  ScreenScale scale;
  Eigen::Vector3d uprightPosition = Eigen::Vector3d::Zero();
};

} // namespace dewpoint::ui

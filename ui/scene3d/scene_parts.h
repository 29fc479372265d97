// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/display_colors.h"
#include "ui/scene3d/camera_frusta.h"
#include "ui/scene3d/frustum_images.h"
#include "ui/scene3d/ground.h"
#include "ui/scene3d/map_actor.h"
#include "ui/scene3d/mean_path.h"
#include "ui/scene3d/ordered_renderer.h"
#include "ui/scene3d/range_actor.h"
#include "ui/scene3d/scene3d.h"
#include "ui/scene3d/target_actors.h"
#include "ui/scene3d/wire_actor.h"

#include <vtkCamera.h>
#include <vtkCullerCollection.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace dewpoint::ui {

/// What a Scene3d consists of, and how it is framed.
class SceneParts {
public:
  using View = Scene3d::View;
  // Thin beside targets and tails: they are not what is looked at.
  static constexpr double kVolumeWidthPx = 1.2; ///< logical
  static constexpr double kSightWidthPx = 1.6;
  /// Targets that are drawn with all that belongs to one; of more, only the mean: by then nobody
  /// can tell them apart, and a picture of thousands of clouds would hold up the window.
  static constexpr std::size_t kMostBodies = 100;

  SceneParts()
      : ground(renderer), images(renderer), frusta(renderer), planned(renderer), map(renderer),
        volume(renderer, kVolumeWidthPx), sight(renderer, kSightWidthPx), range(renderer),
        crowd(renderer) {
    renderer->SetActiveCamera(camera);
    // Cullers ask for bounds that a cloud of bare points does not have.
    renderer->GetCullers()->RemoveAllItems();
  }

  const ScenePalette& palette() const { return scenePalette(dark); }
  ScenePalette plannedPalette() const;
  double rigSize() const { return rigBox.isEmpty() ? 2.0 : rigBox.diagonal().norm(); }
  /// Meters; with images on them they are longer, so that something can be seen there.
  double frustumLength() const {
    return imagesShown ? std::clamp(0.25 * rigSize(), 0.1, 2.0)
                       : std::clamp(0.09 * rigSize(), 0.05, 1.0);
  }
  void applyPalette();
  /// The colors of all targets; to be called when one of them or the ground has changed.
  void applyTargetColors();
  void showRig(const std::shared_ptr<const CameraRig>& shown);
  void include(const TrackSnapshot& snapshot);
  void showCrowd(const TrackSnapshot& snapshot);
  void coverGround();
  Eigen::AlignedBox3d room() const; ///< floor and content
  void frame();
  void keepUpright();
  void setClipping();
  void measure();

  vtkNew<OrderedRenderer> renderer;
  vtkNew<vtkCamera> camera;
  Ground ground;
  FrustumImages images; ///< before all that is drawn over them
  CameraFrusta frusta;
  CameraFrusta planned;
  MapActor map;
  WireActor volume;    ///< of interest
  WireActor sight;     ///< a ray of a camera
  RangeActor range;    ///< before the targets, which are drawn over it
  ParticleCloud crowd; ///< means of the targets beyond `kMostBodies`
  std::vector<std::unique_ptr<TargetActors>> targets;
  std::vector<DisplayColorWish> colorWishes; ///< one per target
  MeanPath path;
  std::shared_ptr<const CameraRig> rig;
  std::shared_ptr<const CameraRig> framedRig; ///< the last one with cameras: what was framed
  Eigen::AlignedBox3d rigBox;                 ///< cameras and what they look at; empty without
  Eigen::AlignedBox3d content;                ///< all that was shown since the rig came
  View view = View::Free;
  bool dark = false;
  int chosenTarget = -1;
  bool bestShown = false;
  bool raysShown = true;
  bool imagesShown = false;
  bool moved = false; ///< by the user
  bool frameWanted = true;
  int width = 0;
  int height = 0;
  ScreenScale scale;
  Eigen::Vector3d uprightPosition = Eigen::Vector3d::Zero();
};

} // namespace dewpoint::ui

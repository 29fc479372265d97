// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/planning/rig_map.h"
#include "core/geometry/world_box.h"
#include "core/session/run/snapshot.h"
#include "ui/scene3d/camera_glyph.h"
#include "ui/scene3d/map_look.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;

namespace dewpoint::ui {

class SceneParts;

/// The room as a scene: ground grid and axes, cameras, particles, estimates, tails, truths.
/// VTK without Qt: whoever owns a render window adds `renderer()` to it. World frame, meters, Z up.
/// Not thread safe; creating it needs no OpenGL context, rendering does.
class Scene3d {
public:
  enum class View {
    Above, ///< parallel projection onto the XY plane, X right, Y up (the papers' view)
    Front, ///< parallel projection onto the XZ plane, looking along +Y, X right, Z up
    Free   ///< perspective, oblique from above at first, to be orbited
  };

  Scene3d();
  ~Scene3d();
  Scene3d(const Scene3d&) = delete;
  Scene3d& operator=(const Scene3d&) = delete;

  /// Owned by the scene.
  vtkRenderer* renderer();
  void setTheme(bool dark);
  /// The sign between whole and parts of numbers, as the user's language writes it.
  void setDecimalPoint(const std::string& sign);
  /// Device pixels per logical pixel: line widths and text sizes follow.
  void setPixelRatio(double ratio);
  /// Shows one frame. Values that are not finite are left out. Each new rig is framed, also one
  /// whose cameras were all calibrated again; what comes to be seen later is framed unless the user
  /// moved the camera.
  void setSnapshot(const TrackSnapshot& snapshot);
  /// Every snapshot that comes, whether it is drawn or not: the next drawing shows the way of the
  /// means of targets that are not held yet.
  void follow(const TrackSnapshot& snapshot);
  /// The selected target; a person stands out. -1: none.
  void choose(int target);
  /// Whether the particle of highest weight of each target is marked; not at first.
  void showBest(bool shown);
  /// Whether a line goes from each camera to the estimate that lies in its image, broken where the
  /// camera does not see the target; at first it does.
  void showRays(bool shown);
  /// Whether the images of the cameras are shown on the pyramids they look through; not at first.
  void showImages(bool shown);
  /// Marks these positions: one stroke for each, meters. Stays until it is called again.
  void highlight(const std::vector<std::vector<Eigen::Vector3d>>& strokes);
  /// How well the cameras see the room; null: nothing is shown of it. Stays until called again.
  void showMap(std::shared_ptr<const RigMap> map, const MapLook& look);
  /// The position on the map's layer that is seen here in the picture, as of the last
  /// `prepareFrame`; nothing without a layer, or beside it. Device pixels as in placeInPicture().
  std::optional<Eigen::Vector3d> placeInLayer(const Eigen::Vector2d& place) const;
  /// The point of this height (world z, meters) at a position in the picture; nothing when that is
  /// seen edge on.
  std::optional<Eigen::Vector3d> placeAtHeight(const Eigen::Vector2d& place, double height) const;
  /// The volume of interest as a wire box; nothing: none. Stays until called again.
  void showVolume(const std::optional<WorldBox>& volume);
  /// A line of sight through the room, from point to point, meters; empty: none. Stays until called
  /// again, and is never framed.
  void showSight(const std::vector<Eigen::Vector3d>& line);
  /// Cameras that are not there (yet), drawn otherwise than those of the rig.
  void showPlanned(const CameraRig& cameras);
  /// Back to the empty grid.
  void clear();
  void look(View view);
  View view() const;
  /// Frames everything again in the current view.
  void resetView();
  /// The user has moved the camera: new rigs no longer move it.
  void keepCamera();
  /// Nearer by `factor` (above 1) or farther (below 1).
  void zoom(double factor);
  /// Before each frame, with the size of the picture in device pixels: framing, clipping range and
  /// all that keeps its size on the screen.
  void prepareFrame(int width, int height);

  /// The color a target is drawn in; of one that is not shown, of the palette.
  SceneColor colorOf(std::size_t target) const;
  /// The cameras as drawn, those of the rig and those that are not there yet.
  std::vector<CameraGlyph> cameraGlyphs() const;
  /// The rectangles that numbers and names of axes take in the picture, as of the last
  /// `prepareFrame`; as in placeInPicture().
  std::vector<Eigen::AlignedBox2d> textsInPicture() const;
  /// The axes of the picture in the world, unit; as of the last `prepareFrame`.
  Eigen::Vector3d rightInPicture() const;
  Eigen::Vector3d upInPicture() const;
  /// Whether a point lies before the eye; else it is nowhere in the picture.
  bool isInFront(const Eigen::Vector3d& point) const;
  /// The world point in the center of the picture, as of the last `prepareFrame`.
  Eigen::Vector3d focus() const;
  /// Where a point is in the picture, as of the last `prepareFrame`: device pixels right of and
  /// above the center.
  Eigen::Vector2d placeInPicture(const Eigen::Vector3d& point) const;
  /// The point that is there, as far from the eye as `depth` is: the inverse of placeInPicture().
  Eigen::Vector3d placeInWorld(const Eigen::Vector2d& place, const Eigen::Vector3d& depth) const;
  /// Length in logical pixels at `point` of a length in meters, as of the last `prepareFrame`.
  double logicalPixels(const Eigen::Vector3d& point, double meters) const;
  /// Meters per device pixel at the focus, as of the last `prepareFrame`.
  double metersPerPixel() const;

private:
  std::unique_ptr<SceneParts> parts_;
};

} // namespace dewpoint::ui

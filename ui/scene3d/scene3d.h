// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/planning/rig_map.h"
#include "core/geometry/world_box.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/scene3d/camera_glyph.h"
#include "ui/scene3d/map_look.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;

namespace dewpoint::ui {

class SceneParts;

/// The room as a 3D scene: ground grid and axes, cameras, particles, estimates, tails, ground
/// truth. Uses VTK without Qt: the owner of a render window adds `renderer()` to it. World
/// coordinates, meters, z up. Not thread safe. Creating it needs no OpenGL context; rendering does.
class Scene3d {
public:
  enum class View {
    Above, ///< parallel projection onto the x-y plane, x right, y up (the view in the papers)
    Front, ///< parallel projection onto the x-z plane, looking along +y, x right, z up
    Free   ///< perspective, at first obliquely from above; the user can orbit
  };

  Scene3d();
  ~Scene3d();
  Scene3d(const Scene3d&) = delete;
  Scene3d& operator=(const Scene3d&) = delete;

  /// The renderer, owned by the scene.
  vtkRenderer* renderer();
  void setTheme(bool dark);
  /// Sets the decimal separator, as in the language of the user.
  void setDecimalPoint(const std::string& sign);
  /// Sets the device pixels per logical pixel, which scale line widths and text sizes.
  void setPixelRatio(double ratio);
  /// Shows one frame. Values that are not finite are left out. The view is fitted to each new rig,
  /// also after a recalibration of all its cameras. It is fitted to objects that appear later,
  /// unless the user moved the view.
  void setSnapshot(const TrackSnapshot& snapshot);
  /// Records every snapshot, whether it is drawn or not. The next drawing shows the path of the
  /// mean of each target that is not held yet.
  void follow(const TrackSnapshot& snapshot);
  /// Highlights the selected target if it is a person; -1: none.
  void choose(int target);
  /// Sets whether the particle with the highest weight of each target is marked; off by default.
  void showBest(bool shown);
  /// Sets whether a line connects each camera with the estimates in its image, broken if the camera
  /// does not see the target; on by default.
  void showRays(bool shown);
  /// Sets whether camera images are shown on the viewing pyramids; off by default.
  void showImages(bool shown);
  /// Highlights positions: one stroke per list, meters. Stays until the next call.
  void highlight(const std::vector<std::vector<Eigen::Vector3d>>& strokes);
  /// Shows the map of expected errors; null: none. Stays until the next call.
  void showMap(std::shared_ptr<const RigMap> map, const MapLook& look);
  /// The position on the map's layer that is seen here in the picture, as of the last
  /// `prepareFrame`; nothing without a layer, or beside it. Device pixels as in placeInPicture().
  std::optional<Eigen::Vector3d> positionInLayer(const Eigen::Vector2d& place) const;
  /// The point of this height (world z, meters) at a position in the picture; nothing when that is
  /// seen edge on.
  std::optional<Eigen::Vector3d> positionAtHeight(const Eigen::Vector2d& place,
                                                  double height) const;
  /// The volume of interest as a wire box; nothing: none. Stays until called again.
  void showVolume(const std::optional<WorldBox>& volume);
  /// Shows a line of sight through the room (points in meters); empty: none. Stays until the next
  /// call. The view is never fitted to it.
  void showSight(const std::vector<Eigen::Vector3d>& line);
  /// Shows planned cameras, drawn differently from those of the rig.
  void showPlanned(const CameraRig& cameras);
  /// Removes everything but the empty grid.
  void clear();
  void look(View view);
  View view() const;
  /// Fits the current view to everything again.
  void resetView();
  /// Reports that the user has moved the view: new rigs no longer change it.
  void keepCamera();
  /// Zooms in by `factor` (above 1) or out (below 1).
  void zoom(double factor);
  /// Prepares the next rendering, with the size of the picture in device pixels: fits the view and
  /// updates the clipping range and everything of constant size on the screen.
  void prepareFrame(int width, int height);

  /// Color in which a target is drawn; the palette color for a target that is not shown.
  SceneColor colorOf(std::size_t target) const;
  /// Cameras as drawn: those of the rig and the planned ones.
  std::vector<CameraGlyph> cameraGlyphs() const;
  /// Areas of the axis numbers and names in the picture, as of the last `prepareFrame`; coordinates
  /// as in `placeInPicture()`.
  std::vector<Eigen::AlignedBox2d> textsInPicture() const;
  /// Right and up axes of the picture as unit vectors in world coordinates, as of the last
  /// `prepareFrame`.
  Eigen::Vector3d rightInPicture() const;
  Eigen::Vector3d upInPicture() const;
  /// Whether a point is in front of the viewer; if not, it has no position in the picture.
  bool isInFront(const Eigen::Vector3d& point) const;
  /// World point at the center of the picture, as of the last `prepareFrame`.
  Eigen::Vector3d focus() const;
  /// Returns the position of a world point in the picture, as of the last `prepareFrame`: device
  /// pixels to the right of and above the center.
  Eigen::Vector2d placeInPicture(const Eigen::Vector3d& point) const;
  /// Returns the world point at a position in the picture, at the same depth as the point `depth`:
  /// the inverse of `placeInPicture()`.
  Eigen::Vector3d placeInWorld(const Eigen::Vector2d& place, const Eigen::Vector3d& depth) const;
  /// Converts a length in meters at `point` to logical pixels, as of the last `prepareFrame`.
  double logicalPixels(const Eigen::Vector3d& point, double meters) const;
  /// Meters per device pixel at the focus, as of the last `prepareFrame`.
  double metersPerPixel() const;

private:
  std::unique_ptr<SceneParts> parts_;
};

} // namespace dewpoint::ui

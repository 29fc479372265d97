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

/// 3D scene of the room: ground grid and axes, cameras, particles, estimates, tails (the drawn
/// recent paths of the targets), ground truth. Uses VTK without Qt: the owner of a VTK render
/// window adds `renderer()` to the window. World coordinates, meters, z up. Not thread-safe. Only
/// rendering needs an OpenGL context.
class Scene3d {
public:
  enum class View {
    Above, ///< parallel projection onto the x-y plane, x right, y up (the view in the papers)
    Front, ///< parallel projection onto the x-z plane, looking along +y, x right, z up
    Side,  ///< parallel projection onto the y-z plane, looking along -x, y right, z up
    Free   ///< perspective, initially obliquely from above; the user can orbit
  };

  Scene3d();
  ~Scene3d();
  Scene3d(const Scene3d&) = delete;
  Scene3d& operator=(const Scene3d&) = delete;

  /// Returns the renderer, which the scene owns.
  vtkRenderer* renderer();
  void setTheme(bool dark);
  /// Sets the decimal separator, which depends on the user's language.
  void setDecimalPoint(const std::string& sign);
  /// Sets the number of device pixels per logical pixel, which scales line widths and text sizes.
  void setPixelRatio(double ratio);
  /// Shows the frame of a snapshot. Values that are not finite are omitted. The view is fitted to
  /// each new rig, including after a recalibration of all cameras. It is also fitted to objects
  /// that appear later, unless the user has moved the view.
  void setSnapshot(const TrackSnapshot& snapshot);
  /// Records a snapshot for the paths of the particle means, which are shown for targets that the
  /// cameras have not yet confirmed. Call this for every snapshot, even if it is not drawn.
  void recordSnapshot(const TrackSnapshot& snapshot);
  /// Highlights the target with this index if it is a person. If `target` is -1, nothing is
  /// highlighted.
  void setChosenTarget(int target);
  /// Sets whether each target's highest-weight particle is marked; off by default.
  void setBestParticleShown(bool shown);
  /// Sets whether a line connects each camera with the estimates in its image; on by default. The
  /// line is dashed if the camera does not see the target.
  void setRaysShown(bool shown);
  /// Sets whether camera images are shown on the viewing pyramids; off by default.
  void setImagesShown(bool shown);
  /// Highlights part of a trajectory, given as positions in meters, one line per list. The
  /// highlight stays until the next call.
  void highlight(const std::vector<std::vector<Eigen::Vector3d>>& strokes);
  /// Shows the map of expected errors, or hides it if `map` is null. Stays in effect until the next
  /// call.
  void showMap(std::shared_ptr<const RigMap> map, const MapOptions& look);
  /// Returns the position on the horizontal map layer that is seen at `place` in the rendered
  /// image, as of the last `prepareRendering()`. Returns nothing outside the layer or if there is
  /// no layer. `place` is in device pixels to the right of and above the image center.
  std::optional<Eigen::Vector3d> positionInMapLayer(const Eigen::Vector2d& place) const;
  /// Returns the point at this height (world z, meters) that is seen at `place` in the rendered
  /// image (device pixels to the right of and above the center). Returns nothing if the plane at
  /// this height is seen edge-on.
  std::optional<Eigen::Vector3d> positionAtHeight(const Eigen::Vector2d& place,
                                                  double height) const;
  /// Shows the volume of interest as a wireframe box, or hides it if `volume` is empty. Stays in
  /// effect until the next call.
  void showVolume(const std::optional<WorldBox>& volume);
  /// Shows a line of sight through the room (points in meters), or hides it if `line` is empty.
  /// Stays in effect until the next call. The view is never fitted to it.
  void showLineOfSight(const std::vector<Eigen::Vector3d>& line);
  /// Shows planned cameras, which are drawn differently from the cameras of the rig.
  void showPlannedCameras(const CameraRig& cameras);
  /// Removes everything except the empty grid.
  void clear();
  void setView(View view);
  View view() const;
  /// Fits the current view to the whole scene again.
  void resetView();
  /// Keeps the current view, as if the user had chosen it: new rigs no longer change the view.
  void keepCurrentView();
  /// Shows the layers and the selected target of another scene, in the same colors and from the
  /// same point of view. If the user has not moved the view of the other scene, this view is fitted
  /// to its own image instead. `aspect` is the width / height of this scene's image; if the image
  /// is narrower than the other one, the view moves back until it shows the same width.
  void copyView(const Scene3d& other, double aspect);
  /// Zooms in by `factor` (above 1) or out (below 1).
  void zoom(double factor);
  /// Prepares the next rendering for an image of this size (device pixels). Fits the view, and
  /// updates the clipping range and everything of constant size on the screen.
  void prepareRendering(int width, int height);

  /// Returns the color in which a target is drawn, or the palette color if the target is not shown.
  SceneColor colorOf(std::size_t target) const;
  /// Returns the viewing pyramids of all cameras in the scene: the cameras of the rig and the
  /// planned cameras.
  std::vector<CameraGlyph> cameraGlyphs() const;
  /// Returns the areas of the axis numbers and names in the rendered image, as of the last
  /// `prepareRendering()`. Coordinates are device pixels to the right of and above the center.
  std::vector<Eigen::AlignedBox2d> textAreas() const;
  /// Return the axis of the rendered image that points right, and the one that points up, as a unit
  /// vector in world coordinates, as of the last `prepareRendering()`.
  Eigen::Vector3d rightAxisInWorld() const;
  Eigen::Vector3d upAxisInWorld() const;
  /// Returns whether a point is in front of the viewer. If it is not, it has no position in the
  /// rendered image.
  bool isInFront(const Eigen::Vector3d& point) const;
  /// Returns the world point at the center of the rendered image, as of the last
  /// `prepareRendering()`.
  Eigen::Vector3d focalPoint() const;
  /// Returns the position of a world point in the rendered image, as of the last
  /// `prepareRendering()`: device pixels to the right of and above the center.
  Eigen::Vector2d projectToImage(const Eigen::Vector3d& point) const;
  /// Returns the world point at `place` in the rendered image (device pixels to the right of and
  /// above the center), at the same depth as the world point `depth`.
  Eigen::Vector3d unproject(const Eigen::Vector2d& place, const Eigen::Vector3d& depth) const;
  /// Converts a length in meters at `point` to logical pixels, as of the last `prepareRendering()`.
  double lengthInLogicalPixels(const Eigen::Vector3d& point, double meters) const;
  /// Returns the meters per device pixel at the focal point, as of the last `prepareRendering()`.
  double metersPerPixel() const;

private:
  std::unique_ptr<SceneParts> parts_;
};

} // namespace dewpoint::ui

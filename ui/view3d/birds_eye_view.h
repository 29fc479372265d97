// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/scene3d/scene3d.h"
#include "ui/view3d/camera_handles.h"
#include "ui/view3d/camera_labels.h"
#include "ui/view3d/map_overlay.h"
#include "ui/view3d/person_badges.h"
#include "ui/view3d/scene_inset.h"
#include "ui/view3d/view_buttons.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::ui {

class ScenePicture;

/// 3D view of the room. VTK renders off-screen, and this widget paints the resulting image, so the
/// rest of the window does not need OpenGL. The view is redrawn at its own rate, slower than the
/// cameras. Without OpenGL, it shows a message.
class BirdsEyeView : public QWidget {
  Q_OBJECT

public:
  explicit BirdsEyeView(QWidget* parent = nullptr);
  ~BirdsEyeView() override;

  /// Sets the OpenGL format that VTK requires. Must be called once before the QApplication is
  /// created.
  static void prepareSurfaceFormat();

  /// Creates the OpenGL context and renders once while hidden, so that the first image appears
  /// without delay.
  void prepareFirstImage();

  /// Sets the snapshot to draw in the next rendering; null clears the scene. This call is fast,
  /// even while the view is hidden.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Shows the whole scene of another project in perspective, regardless of the previous view.
  void resetForNewProject() { lookInPerspective(); }
  /// Highlights part of a trajectory, given as lists of positions (meters). An empty list removes
  /// the highlight.
  void highlight(const std::vector<std::vector<Eigen::Vector3d>>& strokes);

  /// Sets the cameras that can be dragged. The selected camera (index `chosen`) also has a handle
  /// for the point it looks at. If the list is empty, no camera can be dragged.
  void setCameraHandles(std::vector<CameraHandle> handles, int chosen);

  /// Shows the map of expected errors with a legend, or hides it if `map` is null. If several maps
  /// arrive before the next rendering, only the last one is drawn.
  void showMap(std::shared_ptr<const RigMap> map, const MapOptions& look);
  const RigMap* map() const { return map_.map(); }
  const MapOptions& mapOptions() const { return map_.options(); }
  /// Shows planned cameras, which are drawn differently from the cameras in the snapshots.
  void showPlannedCameras(const CameraRig& cameras);

  /// Shows the volume of interest, or hides it if `volume` is empty.
  void showVolume(const std::optional<WorldBox>& volume) {
    scene_.showVolume(volume);
    requestRendering();
  }
  /// Shows a line of sight through the room (meters), or hides it if `line` is empty.
  void showLineOfSight(const std::vector<Eigen::Vector3d>& line) {
    scene_.showLineOfSight(line);
    requestRendering();
  }

  /// Highlights the target with this index if it is a person. If `target` is -1, nothing is
  /// highlighted.
  void setChosenTarget(int target);
  /// Sets whether each target's highest-weight particle is shown.
  void setBestParticleShown(bool shown) {
    scene_.setBestParticleShown(shown);
    requestRendering();
  }
  /// Sets whether lines of sight from the cameras to the estimates are shown.
  void setRaysShown(bool shown) {
    scene_.setRaysShown(shown);
    sceneStale_ = true;
    requestRendering();
  }
  /// Sets whether camera images are shown in the scene.
  void setImagesShown(bool shown) {
    scene_.setImagesShown(shown);
    sceneStale_ = true;
    requestRendering();
  }
  /// Sets the placing mode, in which a click on the floor emits `floorClicked()`. `floor` is the
  /// floor height, world z in meters.
  void setPersonPlacingMode(bool placing, double floor = 0.0);

  /// Copies the appearance of another view, to draw the same scene elsewhere: the layers, the map,
  /// the selected target and the point of view (`Scene3d::copyView()`), but not the snapshot, the
  /// highlights or the planned cameras. Resize this view before the call.
  void copyAppearance(const BirdsEyeView& other);
  Scene3d::View currentView() const;
  /// Returns the current image with its legend but without the buttons, in device pixels; null
  /// without OpenGL.
  QImage currentImage();
  /// Returns the scene as drawn, for conversions between pixels and meters.
  const Scene3d& scene() const { return scene_; }
  const CameraLabels& cameraLabels() const { return labels_; }
  const SceneInset& cloudInset() const { return inset_; }
  /// Returns whether the image shows everything that was last set. Also true while hidden.
  bool isDrawn() const;
  /// Returns false if the first attempt to draw has shown that there is no usable OpenGL.
  bool hasImage() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

public Q_SLOTS:
  void setView(dewpoint::ui::Scene3d::View view);
  void lookFromAbove() { setView(Scene3d::View::Above); }
  void lookFromFront() { setView(Scene3d::View::Front); }
  void lookFromSide() { setView(Scene3d::View::Side); }
  void lookInPerspective() { setView(Scene3d::View::Free); }
  /// Fits the current view to the whole scene.
  void resetView();

Q_SIGNALS:
  void viewChanged(dewpoint::ui::Scene3d::View view);
  /// Emitted after a click on a target's tail (its drawn recent path), with the closest position in
  /// the tail (meters). `extend`: Shift was held down.
  void tailClicked(int target, const Eigen::Vector3d& position, bool extend);
  /// Emitted after a click on the floor in placing mode, with world x and y in meters.
  void floorClicked(const Eigen::Vector2d& position);
  /// Emitted after a click on a person, with the person's index among the targets.
  void personClicked(int target);
  /// Emitted when the user pressed the handle of a camera.
  void cameraChosen(int camera);
  /// cameraDragged() is emitted while a camera is dragged to this world position (meters),
  /// cameraAimed() while the point at which the camera looks is dragged. In the views from above,
  /// from the front and from the side, the drag stays in the plane of the view; in the 3D view, it
  /// is parallel to the image plane.
  void cameraDragged(int camera, const Eigen::Vector3d& center);
  void cameraAimed(int camera, const Eigen::Vector3d& target);
  void cameraDropped();

protected:
  /// Shows a tooltip with the value of the map under the pointer.
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void requestRendering();
  /// Updates the scene before it is rendered.
  void updateScene();
  /// Paints the parts of the image that lie over the rendered scene.
  void paintOver(QPainter& painter) const;
  void applyTheme();
  void retranslateUi();
  void clickTail(QPointF position, bool extend);
  void clickFloor(QPointF position);
  void sendPointer(int what, QPointF position, Qt::KeyboardModifiers modifiers);

  Scene3d scene_;
  std::unique_ptr<ScenePicture> picture_; ///< after the scene: must be destroyed first
  TrackSnapshotPtr snapshot_;
  CameraHandles* handles_;
  CameraLabels labels_;
  SceneInset inset_;
  MapOverlay map_;
  PersonBadges people_; ///< badges in the image
  ViewButtons* buttons_;
  int chosenTarget_ = -1;
  bool placing_ = false;
  double floor_ = 0.0;
  QPointF pressed_; ///< position where the left button was pressed
  bool sceneStale_ = false;
};

} // namespace dewpoint::ui

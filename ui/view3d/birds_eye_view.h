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

/// 3D view of the room. VTK renders into its own off-screen context and this widget paints the
/// resulting image, so OpenGL is not used for the rest of the window. It is redrawn at its own
/// rate, slower than the cameras. Without OpenGL it shows a message, and the program continues.
class BirdsEyeView : public QWidget {
  Q_OBJECT

public:
  explicit BirdsEyeView(QWidget* parent = nullptr);
  ~BirdsEyeView() override;

  /// Must be called once before the QApplication is created.
  static void prepareSurfaceFormat();

  /// Creates the OpenGL context and renders once while hidden, so that the first picture appears
  /// without delay.
  void prepare();

  /// Sets the frame for the next picture; null clears the scene. Cheap, also while hidden.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Shows all of another project in perspective, whatever the view showed before.
  void startAnew() { lookFree(); }
  /// Highlights a part of a trajectory: strokes of positions, meters; empty: none.
  void highlight(const std::vector<std::vector<Eigen::Vector3d>>& strokes);

  /// Sets the cameras that can be dragged; the selected one also has a handle for the point it
  /// looks at. Empty: none.
  void setCameraHandles(std::vector<CameraHandle> handles, int chosen);

  /// Shows the map of expected errors with a legend; null: none. If several maps arrive before the
  /// next picture, only the last one is drawn.
  void showMap(std::shared_ptr<const RigMap> map, const MapLook& look);
  const RigMap* map() const { return map_.map(); }
  const MapLook& mapLook() const { return map_.look(); }
  /// Shows planned cameras, drawn differently from those of the snapshots.
  void showPlanned(const CameraRig& cameras);

  /// Shows the volume of interest; nothing: none.
  void showVolume(const std::optional<WorldBox>& volume) {
    scene_.showVolume(volume);
    requestPicture();
  }
  /// Shows a line of sight through the room, meters; empty: none.
  void showSight(const std::vector<Eigen::Vector3d>& line) {
    scene_.showSight(line);
    requestPicture();
  }

  /// Highlights the selected target if it is a person; -1: none.
  void setChosenTarget(int target);
  /// Sets whether the particle with the highest weight of each target is shown.
  void setBestShown(bool shown) {
    scene_.showBest(shown);
    requestPicture();
  }
  /// Sets whether lines of sight from the cameras to the estimates are shown.
  void setRaysShown(bool shown) {
    scene_.showRays(shown);
    sceneStale_ = true;
    requestPicture();
  }
  /// Sets whether the images of the cameras are shown in the scene.
  void setImagesShown(bool shown) {
    scene_.showImages(shown);
    sceneStale_ = true;
    requestPicture();
  }
  /// Sets the placing mode, in which a click on the floor emits `placeClicked()`. `floor`: its
  /// height, world z in meters.
  void setPlacing(bool placing, double floor = 0.0);

  Scene3d::View currentView() const;
  /// Returns the current picture with its legend, without the buttons, in device pixels; null
  /// without OpenGL.
  QImage currentPicture();
  /// The scene as drawn, for conversions between pixels and meters.
  const Scene3d& scene() const { return scene_; }
  const CameraLabels& cameraLabels() const { return labels_; }
  const SceneInset& cloudInset() const { return inset_; }
  /// Whether the picture shows all that was given last; true while hidden.
  bool isDrawn() const;
  /// False when there is no usable OpenGL (known after the first attempt to draw).
  bool hasPicture() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

public Q_SLOTS:
  void look(dewpoint::ui::Scene3d::View view);
  void lookFromAbove() { look(Scene3d::View::Above); }
  void lookFromFront() { look(Scene3d::View::Front); }
  void lookFree() { look(Scene3d::View::Free); }
  /// Fits the current view to everything.
  void resetView();

Q_SIGNALS:
  void viewChanged(dewpoint::ui::Scene3d::View view);
  /// A click on a target's tail: the nearest position in it, meters. `extend`: with Shift.
  void tailClicked(int target, const Eigen::Vector3d& position, bool extend);
  /// While placing: a click on the floor here, world x and y in meters.
  void floorClicked(const Eigen::Vector2d& position);
  /// A click on a person: its index among the targets.
  void personClicked(int target);
  /// A handle was pressed.
  void cameraChosen(int camera);
  /// A camera, or the point it looks at, is dragged to this world position (meters): in the plane
  /// of a flat view, otherwise parallel to the picture.
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
  void requestPicture();
  /// Before it is drawn.
  void updateScene();
  /// What is part of the picture, but is painted over it.
  void paintOver(QPainter& painter) const;
  void applyTheme();
  void retranslateUi();
  void clickTail(QPointF position, bool extend);
  void clickFloor(QPointF position);
  void sendPointer(int what, QPointF position, Qt::KeyboardModifiers modifiers);

  Scene3d scene_;
  std::unique_ptr<ScenePicture> picture_; ///< after the scene: must go first
  TrackSnapshotPtr snapshot_;
  CameraHandles* handles_;
  CameraLabels labels_;
  SceneInset inset_;
  MapOverlay map_;
  PersonBadges people_; ///< badges in the picture
  ViewButtons* buttons_;
  int chosenTarget_ = -1;
  bool placing_ = false;
  double floor_ = 0.0;
  QPointF pressed_; ///< where the left button went down
  bool sceneStale_ = false;
};

} // namespace dewpoint::ui

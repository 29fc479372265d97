// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/scene3d/scene3d.h"
#include "ui/view3d/camera_handles.h"
#include "ui/view3d/camera_labels.h"
#include "ui/view3d/map_overlay.h"
#include "ui/view3d/person_badges.h"
#include "ui/view3d/scene_inset.h"
#include "ui/view3d/view_buttons.h"

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::ui {

class OffscreenVtk;

/// The 3D picture of the room. VTK renders into its own off-screen context; this widget only paints
/// the resulting image, so the rest of the window is never composed through OpenGL. Draws at its
/// own rate, slower than the cameras. Without OpenGL it says so and the program goes on.
class BirdsEyeView : public QWidget {
  Q_OBJECT

public:
  explicit BirdsEyeView(QWidget* parent = nullptr);
  ~BirdsEyeView() override;

  /// To be called once before the QApplication is made.
  static void prepareSurfaceFormat();

  /// Makes the OpenGL context and draws once, unseen: what the first picture would be waited for.
  void prepare();

  /// Shows a frame with the next picture; null empties the scene. Cheap, also while hidden.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Another project: shows all of it in perspective, whatever was in view before.
  void startAnew() { lookFree(); }
  /// Highlights a part of a trajectory: strokes of positions, meters; none: nothing.
  void highlight(const std::vector<std::vector<Eigen::Vector3d>>& strokes);

  /// Cameras that can be dragged, the chosen one also by what it looks at; empty: none.
  void setCameraHandles(std::vector<CameraHandle> handles, int chosen);

  /// How well the cameras see the room, with a legend; null: nothing is shown of it.
  /// Drawn with the next picture, however many maps come until then.
  void showMap(std::shared_ptr<const RigMap> map, const MapLook& look);
  const RigMap* map() const { return map_.map(); }
  const MapLook& mapLook() const { return map_.look(); }
  /// Cameras that are thought of: drawn otherwise than those of the snapshots.
  void showPlanned(const CameraRig& cameras);

  /// The volume of interest; nothing: none.
  void showVolume(const std::optional<WorldBox>& volume) {
    scene_.showVolume(volume);
    requestPicture();
  }
  /// A line of sight through the room, meters; empty: none.
  void showSight(const std::vector<Eigen::Vector3d>& line) {
    scene_.showSight(line);
    requestPicture();
  }

  /// The selected target; a person stands out. -1: none.
  void setChosenTarget(int target);
  /// The particle of highest weight of each target.
  void setBestShown(bool shown) {
    scene_.showBest(shown);
    requestPicture();
  }
  /// Lines of sight from the cameras to the estimates.
  void setRaysShown(bool shown) {
    scene_.showRays(shown);
    sceneStale_ = true;
    requestPicture();
  }
  /// The images of the cameras, in the scene.
  void setImagesShown(bool shown) {
    scene_.showImages(shown);
    sceneStale_ = true;
    requestPicture();
  }
  /// While placing, a click on the floor of this height (world z, meters) is a placeClicked().
  void setPlacing(bool placing, double floor = 0.0);

  Scene3d::View currentView() const;
  /// The picture as it is now, with its legend but without the buttons; null without OpenGL. Device
  /// pixels.
  QImage currentPicture();
  /// The scene as drawn, for those who convert between pixels and meters.
  const Scene3d& scene() const { return scene_; }
  const CameraLabels& cameraLabels() const { return labels_; }
  const SceneInset& cloudInset() const { return inset_; }
  /// Whether the picture shows all that was given last; true while hidden.
  bool isDrawn() const { return !isVisible() || (!pictureStale_ && !timer_.isActive()); }
  /// False when there is no usable OpenGL (known after the first attempt to draw).
  bool hasPicture() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

public Q_SLOTS:
  void look(dewpoint::ui::Scene3d::View view);
  void lookFromAbove() { look(Scene3d::View::Above); }
  void lookFromFront() { look(Scene3d::View::Front); }
  void lookFree() { look(Scene3d::View::Free); }
  /// Frames everything in the current view.
  void resetView();

Q_SIGNALS:
  void viewChanged(dewpoint::ui::Scene3d::View view);
  /// A click on a target's tail: the nearest position in it, meters. `extend`: with Shift.
  void tailClicked(int target, const Eigen::Vector3d& place, bool extend);
  /// While placing: a click on the floor here, world x and y in meters.
  void placeClicked(const Eigen::Vector2d& place);
  /// A click on a person: its index among the targets.
  void personClicked(int target);
  /// A handle was pressed.
  void cameraChosen(int camera);
  /// A camera (or the point it looks at) is dragged here, meters: in the plane of a flat view, else
  /// parallel to the picture.
  void cameraDragged(int camera, const Eigen::Vector3d& center);
  void cameraAimed(int camera, const Eigen::Vector3d& target);
  void cameraDropped();

protected:
  /// A tool tip over the map says its value there.
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
  void startVtk();
  void requestPicture();
  void renderPicture();
  /// What is part of the picture, but is painted over it.
  void paintOver(QPainter& painter) const;
  void applyTheme();
  void retranslate();
  void clickTail(QPointF position, bool extend);
  void clickFloor(QPointF position);
  void sendPointer(int what, QPointF position, Qt::KeyboardModifiers modifiers);
  QSize pictureSize() const;

  Scene3d scene_;
  std::unique_ptr<OffscreenVtk> vtk_; ///< after the scene: must go first
  TrackSnapshotPtr snapshot_;
  CameraHandles* handles_;
  CameraLabels labels_;
  SceneInset inset_;
  MapOverlay map_;
  PersonBadges people_; ///< in the picture
  ViewButtons* buttons_;
  QImage picture_;
  int chosenTarget_ = -1;
  bool placing_ = false;
  double floor_ = 0.0;
  QPointF pressed_;     ///< where the left button went down
  std::string failure_; ///< why there is no 3D; empty while there is
  QTimer timer_;
  QElapsedTimer sincePicture_;
  qint64 pictureMs_ = 0; ///< what the last one cost
  bool started_ = false;
  bool sceneStale_ = false;
  bool pictureStale_ = true;
};

} // namespace dewpoint::ui

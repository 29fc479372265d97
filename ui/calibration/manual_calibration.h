// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/interactive_pose.h"
#include "core/calibration/manual/point_drag.h"
#include "core/geometry/reference_grid.h"
#include "core/project/project.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::ui {

class CameraListModel;
class Document;
class Selection;

/// Whether the arrow and letter keys change the camera's position (Move) or its orientation (Turn).
enum class KeyMode { Move, Turn };

/// Earlier state of the cameras for the before/after comparison: when the calibration panel was
/// opened, before the last step that changed a camera, or before the last refinement with a wand.
enum class EarlierCameras { PanelOpened, LastChange, WandRefinement };

/// Lets the user adjust the selected camera by hand. Stores the fixed points (pins), and records
/// every change as a named, undoable step of the document. Camera views get from this class what to
/// draw, and send their mouse and keyboard input to it.
class ManualCalibration : public QObject {
  Q_OBJECT
public:
  ManualCalibration(Document& document, Selection& selection, CameraListModel& cameras,
                    QObject* parent = nullptr);

  /// Returns whether a page of the calibration panel that shows the grid is open.
  bool isActive() const { return active_; }
  void setActive(bool active);
  /// Returns whether the grid is drawn over the images and uses their clicks. This is so while a
  /// page that shows the grid is open and no other tool uses the clicks.
  bool takesClicks() const { return active_ && !suspended_; }
  /// If `suspended`, hides the grid and ignores clicks, because another tool uses the images.
  void setSuspended(bool suspended);

  /// Returns the index of the selected camera, or 0 if none is selected.
  int camera() const;
  void selectCamera(int camera);
  CameraListModel& cameras() const { return cameras_; }
  int cameraCount() const;
  /// Returns a camera as the views show it: the current camera of the project or, while an earlier
  /// state is shown, the earlier camera.
  Camera shownCamera(int camera) const;
  Camera cameraInProject(int camera) const;
  QString nameOf(int camera) const;
  /// Returns the project's reference grid, or the standard grid if the project has none.
  ReferenceGrid grid() const;
  /// Changes the grid in an undoable step of the document, named `step`. Successive steps with the
  /// same `mergeKey`, such as the moves of a drag, are merged. Returns false and changes nothing if
  /// the grid cannot be drawn.
  bool setGrid(const QString& step, const ReferenceGrid& grid, const std::string& mergeKey);

  // Appearance of the views.
  double gridOpacity() const { return gridOpacity_; }
  void setGridOpacity(double opacity);
  bool areEdgesShown() const { return edges_; }
  void setEdgesShown(bool shown);
  /// Shows the grid as an earlier state of the cameras sees it, or, if `earlier` is empty, as the
  /// current cameras see it.
  void showEarlierCameras(std::optional<EarlierCameras> earlier);
  bool areEarlierCamerasShown() const { return earlier_.has_value(); }
  /// Returns which earlier state of the cameras is shown for comparison while the user holds down
  /// the button or the key for it on the page "By hand".
  EarlierCameras comparedCameras() const { return comparison_; }
  void setComparedCameras(EarlierCameras compared);
  /// Stores the current cameras for later comparison, as the state `earlier`.
  void storeEarlierCameras(EarlierCameras earlier);

  // Dragging in images.
  const std::vector<Eigen::Vector3d>& pins(int camera) const;
  /// Returns whether grid lines cross at most `reach` pixels from `pixel`.
  bool hasGridCrossingNear(int camera, const Eigen::Vector2d& pixel, double reach) const;
  /// Removes the pin at most `reach` pixels from `pixel`. If there is no pin, pins the grid point
  /// within this distance, if there is one.
  void togglePin(int camera, const Eigen::Vector2d& pixel, double reach);
  /// Returns whether any image has a pin (a fixed point).
  bool hasPins() const;
  /// Removes all pins (fixed points) in all images.
  void clearPins();
  void beginDrag(int camera, const Eigen::Vector2d& pixel, double reach);
  void dragTo(const Eigen::Vector2d& pixel);
  void endDrag();
  /// Restores the camera to its state at the start of the drag.
  void cancelDrag();
  bool isDragging() const { return drag_.has_value(); }
  /// Returns the dragged point in world coordinates (meters), or nothing if no drag is in progress.
  std::optional<Eigen::Vector3d> draggedPoint() const;
  const DragSettings& dragSettings() const { return settings_; }
  void setDragSettings(const DragSettings& settings);

  // Moving or rotating the selected camera with keys.
  KeyMode keyMode() const { return keyMode_; }
  void setKeyMode(KeyMode mode);
  NudgeFrame nudgeFrame() const { return frame_; }
  void setNudgeFrame(NudgeFrame frame);
  /// Moves the camera along axis 0, 1 or 2, or rotates it about that axis, by one step times
  /// `factor`. The axes are right, forward and up in the camera frame, or x, y and z in the world
  /// frame. If `repeated` is true, the key is held down, and the change becomes part of the same
  /// undoable step as the previous one.
  void nudge(int axis, double factor, bool repeated);
  /// Changes the focal length of the selected camera by `percent` percent. If `repeated` is true,
  /// the key is held down, and the change becomes part of the same undoable step as the previous
  /// one.
  void nudgeFocalLength(double percent, bool repeated);

  /// Replaces a camera of the project in an undoable step named `step`. Successive steps with the
  /// same nonempty `mergeKey` are merged.
  void changeCamera(int camera, const QString& step, const Camera& changed,
                    const std::string& mergeKey = {});
  void endStepMerging();

  Document& document() { return document_; }

Q_SIGNALS:
  /// Emitted when something that the views draw has changed.
  void changed();
  void cameraSelected(int camera);
  void activeChanged(bool active);
  /// Emitted when the settings of how the mouse and keys change the camera have changed.
  void settingsChanged();
  /// Emitted with a sentence for the user, for example why a drag cannot continue. An empty
  /// sentence withdraws the previous one.
  void messageRequested(const QString& sentence);

private:
  struct PointDrag {
    int camera;
    Camera cameraAtStart;
    Eigen::Vector3d point; ///< world coordinates, meters
    /// Projection of the point minus the mouse position at the start, so that the point does not
    /// jump.
    Eigen::Vector2d mouseOffset;
    std::vector<ImageAnchor> fixedAnchors;
    QString lastRemark; ///< last remark shown to the user
  };
  struct RunningSum {
    std::string mergeKey;
    double sum = 0.0;
  };
  double runningSum(const std::string& key, double amount, bool repeated);
  void reportLimit(const DragResult& result);
  CameraRig currentCameras() const;
  const CameraRig& camerasOf(EarlierCameras earlier) const;
  /// Forgets the earlier cameras, because the project is another one.
  void resetEarlier();
  /// Stores the cameras before the last change for comparison. Called after each step, undo and
  /// redo of the document; `index` is the new index in the undo stack.
  void followHistory(int index);

  Document& document_;
  Selection& selection_;
  CameraListModel& cameras_;
  bool active_ = false;
  bool suspended_ = false;
  CameraRig whenOpened_;
  CameraRig beforeRefinement_;
  CameraRig beforeLastChange_;
  CameraRig lastSeen_;        ///< cameras of the project after the last step
  int historyIndex_ = 0;      ///< index in the undo stack after the last step that changed a camera
  ReferenceGrid defaultGrid_; ///< used while the project has no grid
  double gridOpacity_ = 0.8;
  bool edges_ = false;
  EarlierCameras comparison_ = EarlierCameras::PanelOpened;
  /// Earlier state of the cameras that is shown now; empty: none.
  std::optional<EarlierCameras> earlier_;
  std::vector<std::vector<Eigen::Vector3d>> pins_;
  std::optional<PointDrag> drag_;
  DragSettings settings_;
  KeyMode keyMode_ = KeyMode::Move;
  NudgeFrame frame_ = NudgeFrame::Camera;
  RunningSum running_;
};

} // namespace dewpoint::ui

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

/// Selects what the arrow and letter keys change: the position or the orientation of the camera.
enum class KeyMode { Move, Turn };

/// Adjusts the selected camera by hand. Keeps the points that are held fixed (pins) and records
/// every change as a named step of the document. Views read what to draw from here and send their
/// mouse and key input here.
class ManualCalibration : public QObject {
  Q_OBJECT
public:
  ManualCalibration(Document& document, Selection& selection, CameraListModel& cameras,
                    QObject* parent = nullptr);

  /// Whether the calibration dock is open. The cameras at the time it opens are the "before" state
  /// of the flip.
  bool isActive() const { return active_; }
  void setActive(bool active);

  /// Index of the selected camera; 0 if none is selected.
  int camera() const;
  void selectCamera(int camera);
  CameraListModel& cameras() const { return cameras_; }
  int cameraCount() const;
  /// Returns the camera as the project has it now, or as it was before while flipped.
  Camera shownCamera(int camera) const;
  Camera cameraAt(int camera) const;
  QString nameOf(int camera) const;
  /// Returns the reference grid of the project, or the standard grid if the project has none.
  ReferenceGrid grid() const;
  /// Changes the grid as a step of the document. Returns false and changes nothing if the grid
  /// cannot be drawn.
  bool setGrid(const QString& step, const ReferenceGrid& grid, const std::string& mergeKey);

  // What the views draw.
  double opacity() const { return opacity_; }
  void setOpacity(double opacity);
  bool edgesShown() const { return edges_; }
  void setEdgesShown(bool shown);
  bool isFlipped() const { return flipped_; }
  void setFlipped(bool flipped);
  /// Makes the current cameras the new "before" state.
  void takeAsBefore();

  // Dragging in images.
  const std::vector<Eigen::Vector3d>& pins(int camera) const;
  /// Pins the grid point at a pixel, or removes the pin that is there. `reach`: search radius in
  /// pixels.
  void togglePin(int camera, const Eigen::Vector2d& pixel, double reach);
  void clearPins(int camera);
  void beginDrag(int camera, const Eigen::Vector2d& pixel, double reach);
  void dragTo(const Eigen::Vector2d& pixel);
  void endDrag();
  /// Restores the camera to its state when the drag began.
  void cancelDrag();
  bool isDragging() const { return drag_.has_value(); }
  /// Returns the dragged point in world coordinates (meters), or nothing if no drag is under way.
  std::optional<Eigen::Vector3d> draggedPoint() const;
  const DragSettings& dragSettings() const { return settings_; }
  void setDragSettings(const DragSettings& settings);

  // Nudges of the selected camera.
  KeyMode keyMode() const { return keyMode_; }
  void setKeyMode(KeyMode mode);
  NudgeFrame nudgeFrame() const { return frame_; }
  void setNudgeFrame(NudgeFrame frame);
  /// Moves the camera along axis 0, 1 or 2, or rotates it about that axis, by one step times
  /// `factor`. The axes are right, forward and up as seen through the camera, or x, y and z of the
  /// world. `repeated`: the key is held down and the step grows.
  void nudge(int axis, double factor, bool repeated);
  /// Changes the focal length by `percent` percent.
  void nudgeFocal(double percent, bool repeated);

  /// Replaces the state of a camera as a step called `step`.
  void change(int camera, const QString& step, const Camera& changed,
              const std::string& mergeKey = {});
  void endMerging();

  Document& document() { return document_; }

Q_SIGNALS:
  /// Something that the views draw has changed.
  void changed();
  void cameraSelected(int camera);
  void activeChanged(bool active);
  /// The settings of dragging or of the keys have changed.
  void settingsChanged();
  /// A sentence for the user, such as why a drag cannot go further. Empty: the earlier sentence no
  /// longer applies.
  void remark(const QString& sentence);

private:
  struct PointDrag {
    int camera;
    Camera start;
    Eigen::Vector3d point; ///< world coordinates, meters
    /// image of the point minus the mouse position at the start, so that the point does not jump
    Eigen::Vector2d grip;
    std::vector<ImageAnchor> held;
    QString limit; ///< remark shown last
  };
  struct Running {
    std::string key;
    double sum = 0.0;
  };
  double runningSum(const std::string& key, double amount, bool repeated);
  void reportLimit(const Drag& result);

  Document& document_;
  Selection& selection_;
  CameraListModel& cameras_;
  bool active_ = false;
  CameraRig before_;
  ReferenceGrid standard_; ///< used while the project has no grid
  double opacity_ = 0.8;
  bool edges_ = false;
  bool flipped_ = false;
  std::vector<std::vector<Eigen::Vector3d>> pins_;
  std::optional<PointDrag> drag_;
  DragSettings settings_;
  KeyMode keyMode_ = KeyMode::Move;
  NudgeFrame frame_ = NudgeFrame::Camera;
  Running running_;
};

} // namespace dewpoint::ui

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

/// What the movement keys change.
enum class KeyMode { Move, Turn };

/// Adjusting the selected camera by hand: which points of it are held, and every change as a named
/// step of the document. Views draw from here and bring their mouse and keys here.
class ManualCalibration : public QObject {
  Q_OBJECT
public:
  ManualCalibration(Document& document, Selection& selection, CameraListModel& cameras,
                    QObject* parent = nullptr);

  /// Whether the calibration dock is open. What cameras are then is the "before" of the flip.
  bool isActive() const { return active_; }
  void setActive(bool active);

  /// The selected camera; the first while none is.
  int camera() const;
  void selectCamera(int camera);
  CameraListModel& cameras() const { return cameras_; }
  int cameraCount() const;
  /// As the project has it now, or as it was before (while flipped).
  Camera shownCamera(int camera) const;
  Camera cameraAt(int camera) const;
  QString nameOf(int camera) const;
  /// The project's grid, or the standard one while it has none.
  ReferenceGrid grid() const;
  /// Changes the grid as a step; false when it cannot be drawn, and nothing changes.
  bool setGrid(const QString& step, const ReferenceGrid& grid, const std::string& mergeKey);

  // What is drawn.
  double opacity() const { return opacity_; }
  void setOpacity(double opacity);
  bool edgesShown() const { return edges_; }
  void setEdgesShown(bool shown);
  bool isFlipped() const { return flipped_; }
  void setFlipped(bool flipped);
  /// From here on "before" is what the cameras are now.
  void takeAsBefore();

  // Dragging in images.
  const std::vector<Eigen::Vector3d>& pins(int camera) const;
  /// Holds the point of the grid at a pixel, or lets go of the one that is held there.
  void togglePin(int camera, const Eigen::Vector2d& pixel, double reach);
  void clearPins(int camera);
  void beginDrag(int camera, const Eigen::Vector2d& pixel, double reach);
  void dragTo(const Eigen::Vector2d& pixel);
  void endDrag();
  /// Takes the camera back to where the drag began.
  void cancelDrag();
  bool isDragging() const { return drag_.has_value(); }
  /// The dragged point of the world, while there is one.
  std::optional<Eigen::Vector3d> draggedPoint() const;
  const DragSettings& dragSettings() const { return settings_; }
  void setDragSettings(const DragSettings& settings);

  // Nudges of the chosen camera.
  KeyMode keyMode() const { return keyMode_; }
  void setKeyMode(KeyMode mode);
  NudgeFrame nudgeFrame() const { return frame_; }
  void setNudgeFrame(NudgeFrame frame);
  /// One step along (or about) axis 0, 1 or 2 (right, forward and up as seen
  /// through the camera, or the world's x, y, z), times `factor`. `repeated`: the key is still
  /// down, the step grows.
  void nudge(int axis, double factor, bool repeated);
  /// Focal length by a number of percent.
  void nudgeFocal(double percent, bool repeated);

  /// Another state of a camera as a step called `step`.
  void change(int camera, const QString& step, const Camera& changed,
              const std::string& mergeKey = {});
  void endMerging();

  Document& document() { return document_; }

Q_SIGNALS:
  /// Something that is drawn changed.
  void changed();
  void cameraSelected(int camera);
  void activeChanged(bool active);
  /// Settings (drag, keys) changed.
  void settingsChanged();
  /// What the user should know: why a drag goes no further. Empty: nothing any more.
  void remark(const QString& sentence);

private:
  struct PointDrag {
    int camera;
    Camera start;
    Eigen::Vector3d point; ///< world
    Eigen::Vector2d grip;  ///< where it was seen, off the mouse: it does not jump when taken
    std::vector<ImageAnchor> held;
    QString limit; ///< what was remarked
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
  ReferenceGrid standard_; ///< while the project has none
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/workbench/workbench.h"

#include <Eigen/Core>
#include <QPointF>

#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::ui {

class BirdsEyeView;
class CameraView;
class ImagePickOverlay;

/// "Correct position" tool. While it is active, the user drags a target in a camera image to its
/// true position in the frame shown, or uses the keyboard cross of the camera views. The tool moves
/// the target whose estimate is pressed, or else the selected target, or else the only target.
/// Other images show the ray through the pointer and the resulting position, including after the
/// drag, so that the user can set the depth in a second image. If the run is playing, it is paused.
class CorrectionTool : public QObject {
  Q_OBJECT
public:
  CorrectionTool(const Workbench& bench, BirdsEyeView& birdsEye, QObject* parent);

  /// Adds a camera view, which may be deleted at any time.
  void attach(int camera, CameraView* view);
  void setActive(bool active);
  /// Sets the snapshot shown, whose estimates can be dragged.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Updates the tool after the corrections or the selection have changed.
  void refresh();
  /// Moves the target `preferredTarget()` (the selected or only target) to a pixel of a camera
  /// image in the frame shown, without a drag. Pauses the run if it is playing.
  void correctAt(int camera, const QPointF& pixel);
  /// Returns whether a target can currently be corrected without a drag (`correctAt()`).
  bool canCorrect() const;
  /// Returns the target that is moved if the user presses away from all estimates, or -1 if this is
  /// ambiguous.
  int preferredTarget() const;

Q_SIGNALS:
  /// Emitted when the target was dropped at a corrected position.
  void corrected(const dewpoint::project::PositionCorrection& correction);
  /// Emitted with the reason why the correction was not possible.
  void failed(const QString& sentence);
  void canceled();

private:
  struct Layer {
    int camera;
    CameraView* view;
    ImagePickOverlay* overlay;
  };
  /// Drag of a target to its true position, with the snapshot in whose image the drag started.
  struct Drag {
    int target; ///< -1 if there is no target to drag
    TrackSnapshotPtr snapshot;
  };
  void grab(const Layer& layer, const QPointF& pixel);
  void point(int camera, const QPointF& pixel);
  void drop(int camera, const QPointF& pixel);
  void reportCorrection(const Drag& drag, int camera, const QPointF& pixel);
  /// Returns the current drag, or the drag that the keyboard would start.
  Drag currentDrag() const;
  /// Returns the target whose estimate is closest to a pixel in the camera view of `layer`, or -1
  /// if no estimate is close enough.
  int targetAt(const Layer& layer, const QPointF& pixel) const;
  std::optional<Gaussian3> estimateOf(const Drag& drag) const;
  Result<PositionCorrection> correctionOf(const Drag& drag, int camera, const QPointF& pixel) const;
  /// Shows the ray of each click in the images of all other cameras, and the position if there is
  /// one.
  void showGuides(const std::vector<PointClick>& clicks,
                  const std::optional<Eigen::Vector3d>& position);
  void showLineOfSight(const PointClick& click, const std::optional<Eigen::Vector3d>& position);
  void clearGuides();

  Workbench bench_;
  BirdsEyeView& birdsEye_;
  std::vector<Layer> layers_;
  TrackSnapshotPtr snapshot_;
  std::optional<Drag> drag_;
  bool active_ = false;
};

} // namespace dewpoint::ui

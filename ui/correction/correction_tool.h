// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/session/run/snapshot.h"
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

/// "It is here": while it is active, a target is dragged in a camera image to where it is in the
/// frame shown; by keys, the cross of the camera views does. What is dragged is the target whose
/// estimate is pressed, else the selected one, else the only one. Other images show the ray through
/// the pointer and the position that comes of it; so they do afterwards, for a second image to fix
/// the depth. A run that plays is paused.
class CorrectionTool : public QObject {
  Q_OBJECT
public:
  CorrectionTool(const Workbench& bench, BirdsEyeView& birdsEye, QObject* parent);

  /// Another camera view, which may go at any time.
  void attach(int camera, CameraView* view);
  void setActive(bool active);
  /// What is shown: the estimates that can be dragged, and the frame.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Corrections or what is selected have changed.
  void refresh();
  /// Says that the target is at a pixel of the image of a camera, in the frame shown, without any
  /// drag: the target of preferredTarget(). A run that plays is paused.
  void correctAt(int camera, const QPointF& pixel);
  /// Whether that can be said now.
  bool canCorrect() const;
  /// The target that a press beside all estimates is about; -1: nobody can tell.
  int preferredTarget() const;

Q_SIGNALS:
  /// The target was let go.
  void corrected(const dewpoint::project::PositionCorrection& correction);
  /// Why nothing came of it.
  void failed(const QString& sentence);
  void cancelled();

private:
  struct Layer {
    int camera;
    CameraView* view;
    ImagePickOverlay* overlay;
  };
  /// What the mouse holds: begun in the image of this snapshot, which stays what it is about.
  struct Drag {
    int target; ///< -1: nothing can be held
    TrackSnapshotPtr snapshot;
  };
  void grab(const Layer& layer, const QPointF& pixel);
  void point(int camera, const QPointF& pixel);
  void drop(int camera, const QPointF& pixel);
  void deliver(const Drag& drag, int camera, const QPointF& pixel);
  /// What is dragged, or would be by keys.
  Drag held() const;
  /// The target whose estimate is nearest to a pixel, if it is near.
  int targetAt(const Layer& layer, const QPointF& pixel) const;
  std::optional<Gaussian3> estimateOf(const Drag& drag) const;
  Result<PositionCorrection> correctionOf(const Drag& drag, int camera, const QPointF& pixel) const;
  /// Rays of clicks in all images but their own; the position where there is one.
  void showGuides(const std::vector<PointClick>& clicks,
                  const std::optional<Eigen::Vector3d>& position);
  void showSight(const PointClick& click, const std::optional<Eigen::Vector3d>& position);
  void clearGuides();

  Workbench bench_;
  BirdsEyeView& birdsEye_;
  std::vector<Layer> layers_;
  TrackSnapshotPtr snapshot_;
  std::optional<Drag> drag_;
  bool active_ = false;
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "ui/cameraview/camera_picture.h"
#include "ui/cameraview/overlay_painter.h"
#include "ui/jobs/latest_job.h"
#include "ui/style/theme.h"

#include <QWidget>

#include <optional>

namespace dewpoint::ui {

/// What one camera sees, letterboxed, and what the filter believes, projected into it: particles,
/// estimate with 95 % ellipse, truth where known, the mask of the target color on demand. Pixels
/// are made beside the window; until those of a newer snapshot are there the last ones are shown,
/// with what was believed then.
class CameraView : public QWidget {
  Q_OBJECT
public:
  /// View of camera `camera` of the rig of the snapshots it is given.
  explicit CameraView(int camera, QWidget* parent = nullptr);

  /// What it shows; null: no images.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  void setMaskShown(bool shown);
  /// Likelihood maps and the positions that were considered.
  void setEvidenceShown(bool shown);
  /// The particle of highest weight of each target.
  void setBestShown(bool shown);
  /// The volume of interest, as an outline; nothing: none.
  void setVolume(const std::optional<WorldBox>& volume);
  /// The selected person stands out; -1: none.
  void setChosenTarget(int target);
  HoldState state() const { return state_; }
  /// Where the image was drawn last, and its size in pixels; an empty size before there was one.
  const ImagePlacement& placement() const { return placement_; }
  const QSize& imageSize() const { return imageSize_; }
  /// Whether what it shows is all that it was given last; true while nobody sees it.
  bool isDrawn() const;

  QSize sizeHint() const override { return {400, 300}; }
  QSize minimumSizeHint() const override { return {120, 90}; }

Q_SIGNALS:
  /// The word in the title of this view changed.
  void stateChanged(HoldState state);

protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  HoldState stateNow() const;
  /// What the picture of the newest snapshot is made of; without a frame: there is none.
  PictureSource source() const;
  /// Device pixels of an image in this view: whole ones, so that it is drawn one to one.
  QSize fittedSize(const QSize& image) const;
  /// Not hidden, nor in a minimized window.
  bool isSeen() const;
  void refresh();
  /// Makes no pictures while nobody sees them, and forgets that of an earlier frame.
  void rest();
  /// Shows the newest snapshot if its picture is there (true), or else begins to make it.
  bool follow();
  void paintBelief(QPainter& painter, const QRectF& picture) const;

  int camera_;
  TrackSnapshotPtr snapshot_; ///< the newest
  bool maskShown_ = false;
  bool evidenceShown_ = false;
  bool bestShown_ = false;
  std::optional<WorldBox> volume_;
  int chosenTarget_ = -1;
  HoldState state_ = HoldState::NoImages;
  ImagePlacement placement_;
  QSize imageSize_;
  CameraPicture picture_;
  TrackSnapshotPtr shown_; ///< the one that picture_ goes with
  PictureSource ordered_;  ///< what job_ works on, or will
  LatestJob job_{LatestJob::Overtaken::Kept};
};

} // namespace dewpoint::ui

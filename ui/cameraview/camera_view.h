// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "ui/cameraview/camera_picture.h"
#include "ui/cameraview/image_placement.h"
#include "ui/cameraview/image_zoom.h"
#include "ui/jobs/latest_job.h"
#include "ui/style/theme.h"

#include <QWidget>

#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::session {
struct CameraOverlay;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// What one camera sees, letterboxed or zoomed, and what the filter believes, projected into it:
/// particles, estimate with 95 % ellipse, truth where known, the mask of the target color on
/// demand. Pixels are made beside the window; until those of a newer snapshot are there the last
/// ones are shown, with what was believed then. What lies over it follows placement().
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
  /// A cloud of particles that is too small to be seen, enlarged in a corner.
  void setMagnifierShown(bool shown);
  /// The volume of interest, as an outline; nothing: none.
  void setVolume(const std::optional<WorldBox>& volume);
  /// The selected person stands out; -1: none.
  void setChosenTarget(int target);
  HoldState state() const { return state_; }
  /// Where the image is, and its size in pixels; an empty size before there was one.
  const ImagePlacement& placement() const { return placement_; }
  const QSize& imageSize() const { return imageSize_; }
  /// What is seen of the image, in this widget.
  QRectF shownArea() const { return placement_.areaOf(imageSize_) & QRectF(rect()); }
  /// The pixel at a position of this widget; nothing beside the image.
  std::optional<QPointF> pixelAt(const QPointF& position) const;
  /// The frame whose pixels are shown; null before there are any.
  const FramePtr& shownFrame() const { return picture_.source.frame; }

  bool isZoomed() const;
  /// Makes the image so many times as large (ImageZoom), the pixel at `position` stays.
  void zoomBy(double factor, const QPointF& position);
  /// Moves the zoomed image.
  void panBy(const QPointF& way);
  /// Moves the zoomed image until a pixel of it is seen.
  void reveal(const QPointF& pixel);
  /// All of the image again.
  void fitImage();
  /// Asks for the menu of the image at a position of this widget.
  void askForMenu(const QPointF& position) { Q_EMIT menuRequested(position); }
  /// Whether what it shows is all that it was given last; true while nobody sees it.
  bool isDrawn() const;

  QSize sizeHint() const override { return {400, 300}; }
  QSize minimumSizeHint() const override { return {120, 90}; }

Q_SIGNALS:
  /// The word in the title of this view changed.
  void stateChanged(HoldState state);
  void menuRequested(const QPointF& position);

protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  HoldState stateNow() const;
  /// What the picture of the newest snapshot is made of; without a frame: there is none.
  PictureSource source() const;
  /// For an image of the frame's size in this view.
  ZoomRoom roomFor(const Frame& frame) const;
  /// Places the image of the newest snapshot; false: there is none.
  bool place();
  /// The zoom has changed.
  void placeAgain();
  /// Where the picture lies: it may be of another part of the image than is seen now.
  QRectF pictureArea() const;
  /// Not hidden, nor in a minimized window.
  bool isSeen() const;
  void refresh();
  /// Makes no pictures while nobody sees them, and forgets that of an earlier frame.
  void rest();
  /// Shows the newest snapshot if its picture is there (true), or else begins to make it.
  bool follow();
  void paintBelief(QPainter& painter) const;
  /// In place of the image.
  QString whyThereIsNoImage() const;
  /// What the target of that number makes of its overlay in this view.
  CameraOverlay overlayOf(std::size_t target) const;
  void paintInset(QPainter& painter, const std::vector<QRectF>& taken) const;

  int camera_;
  TrackSnapshotPtr snapshot_; ///< the newest
  bool maskShown_ = false;
  bool evidenceShown_ = false;
  bool bestShown_ = false;
  bool magnifierShown_ = false;
  std::optional<WorldBox> volume_;
  int chosenTarget_ = -1;
  HoldState state_ = HoldState::NoImages;
  ImageZoom zoom_;
  ImagePlacement placement_;
  QSize imageSize_;
  CameraPicture picture_;
  TrackSnapshotPtr shown_; ///< the one that picture_ goes with
  PictureSource ordered_;  ///< what job_ works on, or will
  LatestJob job_{LatestJob::Overtaken::Kept};
};

} // namespace dewpoint::ui

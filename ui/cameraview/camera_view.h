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

/// Image of one camera, letterboxed or zoomed, with the estimates of the filter projected into it:
/// particles, estimate with 95 % ellipse, ground truth if known and, on demand, the mask of the
/// target color. Pixels are drawn in another thread. Until the pixels of a newer snapshot are
/// ready, the view shows the previous snapshot with its estimates. Overlays follow `placement()`.
class CameraView : public QWidget {
  Q_OBJECT
public:
  /// Creates the view of camera `camera`, an index into the rig of the snapshots.
  explicit CameraView(int camera, QWidget* parent = nullptr);

  /// Sets the snapshot to show; null: no images.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  void setMaskShown(bool shown);
  /// Shows or hides the likelihood maps and the candidate positions.
  void setEvidenceShown(bool shown);
  /// Shows or hides the particle with the highest weight of each target.
  void setBestShown(bool shown);
  /// Shows or hides the inset that enlarges a particle cloud too small to see.
  void setMagnifierShown(bool shown);
  /// Shows the outline of the volume of interest, or none.
  void setVolume(const std::optional<WorldBox>& volume);
  /// Highlights the selected person; -1: none.
  void setChosenTarget(int target);
  HoldState state() const { return state_; }
  /// Placement of the image in the widget, and its size in pixels. The size is empty before the
  /// first image.
  const ImagePlacement& placement() const { return placement_; }
  const QSize& imageSize() const { return imageSize_; }
  /// Visible part of the image, in widget coordinates.
  QRectF shownArea() const { return placement_.areaOf(imageSize_) & QRectF(rect()); }
  /// Returns the pixel at a position of this widget, or nothing outside the image.
  std::optional<QPointF> pixelAt(const QPointF& position) const;
  /// Frame whose pixels are shown; null before the first one.
  const FramePtr& shownFrame() const { return picture_.source.frame; }

  bool isZoomed() const;
  /// Enlarges the image by `factor` (`ImageZoom`); the pixel at `position` (widget coordinates)
  /// stays in place.
  void zoomBy(double factor, const QPointF& position);
  /// Moves the zoomed image by `way`, in widget units.
  void panBy(const QPointF& way);
  /// Moves the zoomed image until a pixel of it is visible.
  void reveal(const QPointF& pixel);
  /// Fits the whole image into the view again.
  void fitImage();
  /// Requests the context menu at a position of this widget.
  void askForMenu(const QPointF& position) { Q_EMIT menuRequested(position); }
  /// Whether the view shows everything it was given last; true while it is not visible.
  bool isDrawn() const;

  QSize sizeHint() const override { return {400, 300}; }
  QSize minimumSizeHint() const override { return {120, 90}; }

Q_SIGNALS:
  /// The state in the title of this view has changed.
  void stateChanged(HoldState state);
  void menuRequested(const QPointF& position);

protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  HoldState stateNow() const;
  /// Returns the input for drawing the newest snapshot; without a frame if there is no picture.
  PictureSource source() const;
  /// Returns the zoom geometry for an image of the size of this frame in this view.
  ZoomRoom roomFor(const Frame& frame) const;
  /// Places the image of the newest snapshot. Returns false if there is none.
  bool place();
  /// Places the image again after the zoom has changed.
  void placeAgain();
  /// Area of the drawn picture, widget coordinates. The picture may cover another part of the image
  /// than is visible now.
  QRectF pictureArea() const;
  /// Whether the view is visible, in a window that is not minimized.
  bool isSeen() const;
  void refresh();
  /// Stops drawing while the view is not visible, and drops the picture of an earlier frame.
  void rest();
  /// Returns true and shows the newest snapshot if its picture is ready; otherwise starts drawing
  /// the picture.
  bool follow();
  void paintBelief(QPainter& painter) const;
  /// Text shown in place of the image when there is none.
  QString whyThereIsNoImage() const;
  /// Returns the overlay of a target in this view.
  CameraOverlay overlayOf(std::size_t target) const;
  void paintInset(QPainter& painter, const std::vector<QRectF>& taken) const;

  int camera_;
  TrackSnapshotPtr snapshot_; ///< newest snapshot
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
  TrackSnapshotPtr shown_; ///< snapshot that belongs to `picture_`
  PictureSource ordered_;  ///< input that `job_` works on, or will work on
  LatestJob job_{LatestJob::Overtaken::Kept};
};

} // namespace dewpoint::ui

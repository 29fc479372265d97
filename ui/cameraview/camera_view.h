// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "ui/cameraview/camera_image.h"
#include "ui/cameraview/camera_picture.h"
#include "ui/cameraview/image_placement.h"
#include "ui/cameraview/image_zoom.h"
#include "ui/jobs/latest_job.h"
#include "ui/style/theme.h"

#include <QWidget>

#include <cstdint>
#include <optional>

namespace dewpoint::ui {

/// View of the image of one camera, fitted or zoomed, with the filter estimates projected into it:
/// particles, the estimate with its 95 % ellipse, ground truth if known, and optionally the mask of
/// the target color. Pixels are drawn in another thread. Until the pixels of a newer snapshot are
/// ready, the view shows the previous snapshot with its estimates. Overlays follow `placement()`.
class CameraView : public QWidget {
  Q_OBJECT
public:
  /// Creates the view for the camera with index `camera` in the rig of the snapshots.
  explicit CameraView(int camera, QWidget* parent = nullptr);

  /// Sets the snapshot to show. If it is null, no image is shown.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  void setMaskShown(bool shown);
  /// Shows or hides the likelihood maps and the candidate positions.
  void setLikelihoodShown(bool shown);
  /// Shows or hides each target's highest-weight particle.
  void setBestParticleShown(bool shown);
  /// Shows or hides the inset that enlarges a particle cloud that is too small to see.
  void setMagnifierShown(bool shown);
  /// Shows the outline of the volume of interest. If `volume` is empty, no outline is shown.
  void setVolume(const std::optional<WorldBox>& volume);
  /// Highlights the target with this index if it is a person. If `target` is -1, no person is
  /// highlighted.
  void setChosenTarget(int target);
  /// Returns which layers are shown, for example to draw this view elsewhere.
  CameraViewOptions options() const;
  int camera() const { return camera_; }
  TrackingState state() const { return state_; }
  /// Return the placement of the image in the widget, and the image size in pixels. The size is
  /// empty before the first image.
  const ImagePlacement& placement() const { return placement_; }
  const QSize& imageSize() const { return imageSize_; }
  /// Returns the visible part of the image in widget coordinates.
  QRectF shownArea() const { return placement_.areaOf(imageSize_) & QRectF(rect()); }
  /// Returns the image pixel at a widget position, or nothing if the position is outside the image.
  std::optional<QPointF> pixelAt(const QPointF& position) const;
  /// Returns the frame whose pixels are shown, or null before the first one.
  const FramePtr& shownFrame() const { return picture_.source.frame; }

  bool isZoomed() const;
  /// Enlarges the image by `factor`, within the limits of `ImageZoom`. The pixel at `position`
  /// (widget coordinates) stays in place.
  void zoomBy(double factor, const QPointF& position);
  /// Moves the zoomed image by `offset`, in widget units.
  void panBy(const QPointF& offset);
  /// Moves the zoomed image until `pixel` is visible.
  void reveal(const QPointF& pixel);
  /// Fits the whole image into the view again.
  void fitImage();
  /// Requests the context menu at a position in this widget.
  void requestMenu(const QPointF& position) { Q_EMIT menuRequested(position); }
  /// Returns whether the newest snapshot and settings are drawn. Also true while the view is not
  /// visible.
  bool isDrawn() const;

  QSize sizeHint() const override { return {400, 300}; }
  QSize minimumSizeHint() const override { return {120, 90}; }

Q_SIGNALS:
  /// Emitted when the tracking state that this view shows has changed.
  void stateChanged(TrackingState state);
  void menuRequested(const QPointF& position);
  /// Emitted when a new live estimate is painted, with the time since it was finished in seconds.
  void estimatePainted(double secondsSinceFinished);

protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  TrackingState currentState() const;
  /// Returns the input for drawing the newest snapshot. Its frame is null if there is no image.
  CameraImageSource source() const;
  /// Returns the zoom geometry for an image of this frame's size in this view.
  ZoomSizes zoomSizesFor(const Frame& frame) const;
  /// Updates the placement for the newest snapshot's image. Returns false if there is none.
  bool updatePlacement();
  /// Updates the placement after the zoom has changed.
  void onZoomChanged();
  /// Returns the area of the drawn pixels in widget coordinates. They may cover a different part of
  /// the image than is visible now.
  QRectF drawnArea() const;
  /// Returns whether the view is visible, in a window that is not minimized.
  bool isVisibleOnScreen() const;
  void refresh();
  /// Stops drawing because the view is not visible, and discards the pixels of an earlier frame.
  void stopDrawing();
  /// Shows the newest snapshot and returns true if its pixels are ready. Otherwise starts drawing
  /// them.
  bool showNewest();
  /// Reports how long it took until the frame shown was painted, once.
  void reportPainted();
  /// Returns why a live camera delivers no images now; empty if it delivers them.
  QString problemText() const;

  int camera_;
  TrackSnapshotPtr snapshot_; ///< newest snapshot
  CameraViewOptions look_;    ///< without the palette
  TrackingState state_ = TrackingState::NoImages;
  ImageZoom zoom_;
  ImagePlacement placement_;
  QSize imageSize_;
  CameraImage picture_;
  TrackSnapshotPtr shown_;            ///< snapshot that belongs to `picture_`
  std::int64_t reportedFrame_ = -1;   ///< last frame in reportPainted()
  CameraImageSource requestedSource_; ///< input that `job_` is processing or will process
  LatestJob job_{LatestJob::SupersededJob::Kept};
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/timeline/requested_frame.h"
#include "ui/timeline/timeline_model.h"
#include "ui/timeline/timeline_painter.h"
#include "ui/timeline/timeline_scale.h"

#include <QWidget>

#include <algorithm>
#include <optional>
#include <utility>

namespace dewpoint::ui {

class Document;
class MarkerEditor;

/// Timeline of the run: the state of each target, missing camera images, markers, and the current
/// frame. Dragging shows the frame under the pointer. Dragging on the axis, or with Shift, selects
/// a range. The wheel zooms. The arrow keys move by frames, the page keys by seconds, and Home and
/// End to the first and last frame.
class Timeline : public QWidget {
  Q_OBJECT
public:
  Timeline(Selection& selection, Document& document, QWidget* parent = nullptr);

  /// Sets the snapshot, which describes the run. Null means that there is no run, and the timeline
  /// is empty.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  void append(const std::vector<FrameRecord>& records, bool restarted);
  /// Sets the frames whose results are from earlier settings.
  void setOldResults(const std::vector<ResultRange>& frames) {
    model_.oldResults = frames;
    update();
  }
  void clear();

  /// Shows the frame that is `frames` frames after the current frame, or after the frame requested
  /// last.
  void step(qint64 frames);
  /// Shows this frame, which must be in reachableFrames().
  void goToFrame(qint64 frame) { requestFrame(frame); }
  /// Returns the first and the last frame that can be shown.
  std::pair<qint64, qint64> reachableFrames() const {
    return {model_.isLive ? model_.history.firstFrame : scale_.firstFrame(), scale_.lastFrame()};
  }
  /// Returns the frame requested last or, if no request is pending, the current frame.
  qint64 latestFrame() const;
  /// Shows the next (1) or previous (-1) frame in which the selected target (any target if none is
  /// selected) becomes ambiguous, searching or lost, or in which a live camera begins to have a
  /// problem. Returns false if there is no such frame.
  bool stepToProblem(int direction);
  /// Shows the frame of the next (1) or previous (-1) marker.
  void stepToMarker(int direction);
  /// Adds a marker at the current frame in an undoable step, and edits its name in place.
  void addMarker();
  /// Removes the marker at the current frame. Returns false if there is none.
  bool removeMarker();
  /// Sets the frame under the pointer in another view; negative if there is none.
  void setHoveredFrame(qint64 frame);
  void zoomToRange();
  void zoomOut();

  const TimelineModel& model() const { return model_; }
  /// Returns the center of a frame in the row of the first target, in widget coordinates.
  QPoint positionOf(qint64 frame) const;

  QSize sizeHint() const override { return {600, std::max(110, minimumHeight_)}; }
  /// Returns the minimum size, which grows with the number of rows.
  QSize minimumSizeHint() const override { return {240, std::max(84, minimumHeight_)}; }

Q_SIGNALS:
  /// Emitted when the pointer has moved to this frame; negative if the pointer is on no frame.
  void frameHovered(qint64 frame);
  /// Emitted when a menu for the current frame is requested at this screen position.
  void menuRequested(const QPoint& place);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  TimelineRows rows() const;
  int dropoutCameraCount() const;
  void place();
  void requestFrame(qint64 frame, bool extendsRange = false);
  void selectTo(qint64 frame);
  std::optional<std::size_t> markerAt(const QPointF& point) const;
  void updateMarkers();
  void editName(const ProjectMarker& marker);
  void announceFrame();
  void hover(const QPointF& place);

  Selection& selection_;
  Document& document_;
  TimelineModel model_;
  TimelineScale scale_;
  enum class Drag { None, Frame, Range };
  Drag drag_ = Drag::None;
  qint64 hovered_ = -1;
  qint64 anchor_ = -1; ///< frame where the range begins
  RequestedFrame requested_;
  MarkerEditor* markers_;
  double gutter_ = 90.0;
  int minimumHeight_ = 0; ///< height at which all rows are readable, pixels
};

} // namespace dewpoint::ui

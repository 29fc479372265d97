// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/jobs/latest_job.h"

#include <Eigen/Core>
#include <QImage>
#include <QWidget>

#include <optional>

namespace dewpoint::ui {

class CameraView;
class ManualCalibration;
class PointCalibrator;

/// Lies over a camera view while cameras are adjusted by hand: draws the reference grid, pins and
/// measured points over the image, and takes mouse and keys. Drag: the grid follows. Click: a point
/// is held, or let go. Arrows, W A S D, Q and E move or turn the camera; Shift coarse, Ctrl (with
/// arrows, page keys, plus and minus) fine.
class GridLayer : public QWidget {
  Q_OBJECT
public:
  GridLayer(int camera, CameraView* view, ManualCalibration& hand, PointCalibrator& points);

  void setSnapshot(const TrackSnapshotPtr& snapshot);
  int camera() const { return camera_; }
  /// Whether the edges, if they are shown, are those of the newest image; true while hidden.
  bool isDrawn() const;

protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;

private:
  void retranslateUi();
  void follow();
  /// What edges are found in: nothing while they are not shown.
  struct EdgeSource {
    FramePtr frame;
    QSize size; ///< device pixels: no more than are seen
    bool operator==(const EdgeSource&) const = default;
  };
  EdgeSource edgeSource() const;
  void followEdges();
  void drawEdges(QPainter& painter);
  void drawPoints(QPainter& painter);
  void drawMagnifier(QPainter& painter);
  void drawLabel(QPainter& painter);
  FramePtr frame() const;
  Eigen::Vector2d pixelAt(QPointF position) const;
  bool isInside(const Eigen::Vector2d& pixel) const;
  /// Pixels of the image that are this number of the widget's.
  double inImage(double widgetPixels) const;
  /// Where a click is taken to be: at a corner nearby, unless Alt is down.
  Eigen::Vector2d clicked(QPointF position, Qt::KeyboardModifiers modifiers) const;
  void placeClick(QMouseEvent* event);

  int camera_;
  CameraView* view_;
  ManualCalibration& hand_;
  PointCalibrator& points_;
  TrackSnapshotPtr snapshot_;
  std::optional<QPointF> pressed_; ///< widget; not yet known whether it is a click or a drag
  std::optional<QPointF> pointer_; ///< widget
  bool exact_ = false;             ///< Alt: no snapping
  EdgeSource edgesOf_;             ///< of edges_
  EdgeSource edgesOrdered_;        ///< what edgeJob_ works on, or will
  QImage edges_;
  LatestJob edgeJob_{LatestJob::Overtaken::Kept};
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/jobs/latest_job.h"

#include <Eigen/Core>
#include <QImage>
#include <QWidget>

#include <optional>

namespace dewpoint::ui {

class CameraView;
class ManualCalibration;
class PointCalibrator;

/// Camera view overlay for calibration by hand. Draws the reference grid, pins and measured points
/// over the image, and handles mouse and keyboard input. A drag moves the grid. A click pins a grid
/// point or removes its pin. A double click away from pins and from crossings of grid lines fits
/// the image into the view. Arrows, W A S D, Q and E move or rotate the camera. Shift takes coarse
/// steps. Ctrl (with arrows, page keys, plus and minus) takes fine steps.
class GridLayer : public QWidget {
  Q_OBJECT
public:
  GridLayer(int camera, CameraView* view, ManualCalibration& manual, PointCalibrator& points);

  void setSnapshot(const TrackSnapshotPtr& snapshot);
  int camera() const { return camera_; }
  /// Returns the text that is shown in the corner while the grid is drawn as an earlier state of
  /// the cameras sees it; otherwise an empty string.
  QString shownLabel() const;
  /// Returns whether the edges drawn over the image come from the newest image. Also true while no
  /// edges are shown.
  bool isDrawn() const;

protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;

private:
  void retranslateUi();
  void refresh();
  /// Input for the edge detection; empty while edges are hidden.
  struct EdgeSource {
    FramePtr frame;
    QSize size; ///< device pixels; at most the displayed size
    bool operator==(const EdgeSource&) const = default;
  };
  EdgeSource edgeSource() const;
  void followEdges();
  void drawEdges(QPainter& painter);
  void drawPoints(QPainter& painter);
  void drawMagnifier(QPainter& painter);
  void drawLabel(QPainter& painter);
  /// Returns whether a line of the grid runs through the visible part of the image.
  bool isGridInSight() const;
  FramePtr frame() const;
  Eigen::Vector2d pixelAt(QPointF position) const;
  bool isInside(const Eigen::Vector2d& pixel) const;
  /// Converts a length in widget pixels to image pixels.
  double toImagePixels(double widgetPixels) const;
  /// Returns the image pixel that a click refers to. It snaps to a nearby corner unless Alt is held
  /// down.
  Eigen::Vector2d clicked(QPointF position, Qt::KeyboardModifiers modifiers) const;
  void placeClick(QMouseEvent* event);

  int camera_;
  CameraView* view_;
  ManualCalibration& manual_;
  PointCalibrator& points_;
  TrackSnapshotPtr snapshot_;
  enum class Click { None, SetPin, RemovedPin };
  Click lastClick_ = Click::None; ///< what the last click did
  /// Where the mouse was pressed, widget coordinates; empty while it is not pressed.
  std::optional<QPointF> pressed_;
  std::optional<QPointF> pointer_; ///< position of the mouse pointer, widget coordinates
  bool exact_ = false;     ///< true while Alt is held down, so that clicks do not snap to corners
  EdgeSource edgesSource_; ///< image and size from which `edges_` was computed
  EdgeSource requestedEdges_; ///< image and size that `edgeJob_` is processing or will process
  QImage edges_;
  LatestJob edgeJob_{LatestJob::SupersededJob::Kept};
};

} // namespace dewpoint::ui

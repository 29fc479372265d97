// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace dewpoint::ui {

class CameraView;

/// Camera view overlay with which the user points at objects in the image ("picks" a pixel or a
/// box), and which outlines regions. A drag that no tool uses moves a zoomed image; a double click
/// fits the image. While the overlay has the focus and is picking, the arrow keys move a cross
/// (with Ctrl by one pixel), and Enter picks the pixel at the cross. Shift and Alt have the same
/// effect as with a click.
class ImagePickOverlay : public QWidget {
  Q_OBJECT
public:
  explicit ImagePickOverlay(CameraView* view);

  /// Sets whether a plain click picks a pixel for a tool. A click with Shift or Alt always does.
  void setPicking(bool picking);
  /// Sets whether a magnifier shows the pixels under the pointer while picking. The magnifier
  /// appears only if pixels are small.
  void setMagnifying(bool magnifying) { magnifying_ = magnifying; }
  /// Sets whether a drag moves a point instead of drawing a box. Such a drag emits `pointGrabbed()`
  /// at the start, `pointMoved()` during the drag, and `picked()` at the end.
  void setPointDragging(bool pointing) { pointing_ = pointing; }
  /// Sets the pixel where the keyboard cross starts; the image center by default.
  void setCrossStart(std::optional<QPointF> start) { crossStart_ = start; }
  /// Draws thin lines and a cross over the image, in image pixels.
  void setGuides(std::vector<QPolygonF> lines, std::optional<QPointF> point);
  const std::vector<QPolygonF>& guideLines() const { return guideLines_; }
  const std::optional<QPointF>& guidePoint() const { return guidePoint_; }
  /// Outline of a region in image pixels, with a label.
  struct Region {
    QPolygonF outline;
    QString text;
    bool operator==(const Region&) const = default;
  };
  void setRegions(std::vector<Region> regions);
  /// Sets the hint that is shown at the lower edge of the image while picking, to explain what a
  /// click does. An empty string removes the hint.
  void setHint(const QString& hint);
  /// Returns the hint that is shown now, or an empty string.
  QString shownHint() const { return picking_ ? hint_ : QString(); }

Q_SIGNALS:
  /// Emitted after a click (`region` has an empty size) or a dragged box, in image pixels.
  void picked(const QRectF& region, Qt::KeyboardModifiers modifiers);
  /// Emitted while a point is dragged: `pointGrabbed()` when the mouse button is pressed;
  /// `pointMoved()` when the point moves, also by keys; `dragEnded()` when the drag is over, after
  /// `picked()` if a pixel was picked. Positions are in image pixels.
  void pointGrabbed(const QPointF& pixel);
  void pointMoved(const QPointF& pixel);
  void dragEnded();
  /// Emitted when Esc is pressed, which ends picking.
  void canceled();
  /// Emitted when the user presses the mouse button on the image, or picks a pixel with the
  /// keyboard. The camera of this view must then be selected.
  void viewChosen();
  /// Emitted after viewChosen() for a plain click outside picking mode, with its position in image
  /// pixels.
  void imageClicked(const QPointF& pixel);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

private:
  /// Returns the image pixel closest to a widget position.
  QPointF nearestPixel(QPointF position) const;
  /// Draws a magnifier next to the pointer or the cross if pixels are small.
  void paintMagnified(QPainter& painter) const;
  /// Ends dragging the point.
  void endPointing();
  /// Returns whether this key press moves the cross or picks.
  bool controlsCross(const QKeyEvent& event) const;
  void moveCross(int key, bool fine);

  CameraView* view_;
  bool picking_ = false;
  bool pointing_ = false;
  std::optional<QPointF> crossStart_;
  std::vector<QPolygonF> guideLines_;
  std::optional<QPointF> guidePoint_;
  std::vector<Region> regions_;
  QString hint_;
  bool magnifying_ = true;
  struct Press {
    QPointF position; ///< widget coordinates
    QPointF pixel;    ///< pixel under the press, which stays valid if the zoom changes meanwhile
  };
  std::optional<Press> pressed_;
  /// Last mouse position, widget coordinates; set while a press moves the image.
  std::optional<QPointF> panned_;
  /// Position of the mouse pointer, widget coordinates; set while picking.
  std::optional<QPointF> pointer_;
  /// Image pixel at the cross that the arrow keys move; empty: no cross.
  std::optional<QPointF> cross_;
  QPointF pointerPosition_;
};

} // namespace dewpoint::ui

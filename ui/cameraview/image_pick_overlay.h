// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace dewpoint::ui {

class CameraView;

/// Lies over a camera view: lets the user point at objects in its image, and outlines regions of
/// it. A drag that means no tool moves a zoomed image, a double click fits it. By keys: while it
/// has the focus and picks, the arrows move a cross (Ctrl: one pixel at a time), Enter points
/// there; with Shift or Alt as with a click.
class ImagePickOverlay : public QWidget {
  Q_OBJECT
public:
  explicit ImagePickOverlay(CameraView* view);

  /// Whether a plain click picks; with Shift or Alt it always does.
  void setPicking(bool picking);
  /// Whether a loupe shows what is under the pointer while it picks, where pixels are small.
  void setMagnifying(bool magnifying) { magnifying_ = magnifying; }
  /// A drag moves a point instead of opening a box: grabbed(), pointed() on its way, and picked()
  /// where it is let go.
  void setPointing(bool pointing) { pointing_ = pointing; }
  /// Where the cross of the keys begins, a pixel of the image; nothing: in its middle.
  void setCrossStart(std::optional<QPointF> start) { crossStart_ = start; }
  /// Thin lines over the image and a cross, in pixels of it.
  void setGuides(std::vector<QPolygonF> lines, std::optional<QPointF> point);
  const std::vector<QPolygonF>& guideLines() const { return guideLines_; }
  const std::optional<QPointF>& guidePoint() const { return guidePoint_; }
  /// Regions of the image, in pixels, with a word each.
  struct Region {
    QPolygonF outline;
    QString text;
  };
  void setRegions(std::vector<Region> regions);
  /// What a click is for, shown at the lower edge of the image while it picks; empty: nothing.
  void setHint(const QString& hint);

Q_SIGNALS:
  /// A click (an empty size) or a dragged box, in pixels of the image.
  void picked(const QRectF& region, Qt::KeyboardModifiers modifiers);
  /// Of a point that is dragged: the mouse went down, and where the point is since, also by keys;
  /// pixels of the image. At last picked() or not, and then that it is over.
  void grabbed(const QPointF& pixel);
  void pointed(const QPointF& pixel);
  void pointingEnded();
  /// Esc: nothing more is to be pointed at.
  void cancelled();
  /// A plain click while nothing is being picked: the view was chosen.
  void chosen();
  /// Where that was, pixels of the image.
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
  /// The pixel of the image that is nearest to a position.
  QPointF nearestPixel(QPointF position) const;
  /// A loupe beside the pointer or the cross, where pixels are small.
  void paintMagnified(QPainter& painter) const;
  /// Nothing is pointed at any more.
  void endPointing();
  /// Whether the key moves the cross or points, when it is pressed here.
  bool isForCross(const QKeyEvent& event) const;
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
    QPointF position; ///< widget
    QPointF pixel;    ///< what it is about, also when the image is zoomed meanwhile
  };
  std::optional<Press> pressed_;
  std::optional<QPointF> panned_;  ///< widget; while a press means no tool
  std::optional<QPointF> pointer_; ///< widget, while it picks
  std::optional<QPointF> cross_;   ///< pixel of the image; moved by keys
  QPointF now_;
};

} // namespace dewpoint::ui

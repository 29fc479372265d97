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
/// it. By keys: while it has the focus and picks, the arrows move a cross (Ctrl: one pixel at a
/// time), Enter points there; with Shift or Alt as with a click.
class ImagePickOverlay : public QWidget {
  Q_OBJECT
public:
  explicit ImagePickOverlay(CameraView* view);

  /// Whether a plain click picks; with Shift or Alt it always does.
  void setPicking(bool picking);
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
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

private:
  std::optional<QPointF> pixelAt(QPointF position) const;
  QPointF pixelOf(QPointF position) const;
  /// The position in the image that is nearest to a position.
  QPointF nearestPixel(QPointF position) const;
  QPointF positionOf(QPointF pixel) const;
  void paintHint(QPainter& painter) const;
  /// Whether the key moves the cross or points, when it is pressed here.
  bool isForCross(const QKeyEvent& event) const;
  void moveCross(int key, bool fine);

  CameraView* view_;
  bool picking_ = false;
  std::vector<Region> regions_;
  QString hint_;
  std::optional<QPointF> pressed_; ///< widget
  std::optional<QPointF> cross_;   ///< pixel of the image; moved by keys
  QPointF now_;
};

} // namespace dewpoint::ui

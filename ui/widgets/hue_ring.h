// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QImage>
#include <QWidget>

#include <vector>

namespace dewpoint::ui {

/// Color ring of hues that shows a range as an arc. The user can drag the ends or the whole arc.
/// With the keyboard, Tab selects an end or the arc and the arrow keys move it. Values are in
/// degrees, 0 to 360. If from > to, the range wraps through red.
class HueRing : public QWidget {
  Q_OBJECT
public:
  explicit HueRing(QWidget* parent = nullptr);

  void setRange(double from, double to);
  double rangeStartDegrees() const { return from_; }
  double rangeEndDegrees() const { return to_; }
  /// Sets the frequency of each hue in the image, in equal bins starting at 0 degrees. It is drawn
  /// inside the ring.
  void setHistogram(std::vector<double> counts);

  QSize sizeHint() const override { return {200, 200}; }
  QSize minimumSizeHint() const override { return {140, 140}; }

Q_SIGNALS:
  void rangeEdited(double from, double to);
  /// Emitted when a drag has ended. The next change is a new undo step.
  void editingFinished();

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void focusInEvent(QFocusEvent* event) override;

private:
  enum class Part { None, From, To, Arc };
  double radius() const;
  QPointF pointAt(double hue, double distance) const;
  double hueAt(QPointF position) const;
  Part partAt(QPointF position) const;
  void move(Part part, double degrees);
  void paintHistogram(QPainter& painter) const;
  void paintRange(QPainter& painter) const;
  const QImage& wheel();

  double from_ = 0.0;
  double to_ = 60.0;
  std::vector<double> histogram_;
  Part dragged_ = Part::None;
  Part chosen_ = Part::Arc; ///< part selected with the keyboard
  double lastHue_ = 0.0;
  QImage wheel_;
};

} // namespace dewpoint::ui

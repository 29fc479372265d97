// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <vector>

namespace dewpoint::ui {

/// Bar from 0 to 1 that shows a range, with the image histogram behind it. The user can drag the
/// ends or the whole range. With the keyboard, Tab selects a part and the arrow keys move it.
class RangeBar : public QWidget {
  Q_OBJECT
public:
  explicit RangeBar(QWidget* parent = nullptr);

  void setRange(double from, double to);
  double rangeStart() const { return from_; }
  double rangeEnd() const { return to_; }
  /// Sets the frequency of each value in the image, in equal bins from 0 to 1.
  void setHistogram(std::vector<double> counts);
  /// Sets the colors under the bar, at 0 and at 1.
  void setColors(const QColor& low, const QColor& high);

  QSize sizeHint() const override { return {200, 44}; }
  QSize minimumSizeHint() const override { return {120, 44}; }

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
  enum class Part { None, From, To, Both };
  QRectF bar() const;
  double xOf(double value) const;
  double valueAt(double x) const;
  Part partAt(QPointF position) const;
  void move(Part part, double change);

  double from_ = 0.0;
  double to_ = 1.0;
  std::vector<double> histogram_;
  QColor low_;
  QColor high_;
  Part dragged_ = Part::None;
  Part chosen_ = Part::Both;
  double lastValue_ = 0.0;
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>
#include <QPoint>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

class QCPAxis;
class QCustomPlot;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace dewpoint::ui {

class PlotNavigation;

/// Mouse and keyboard input for a stack of plots:
/// - The wheel scrolls the stack. With Ctrl, it zooms at the pointer; with Shift, it pans.
/// - + and - zoom around the cursor.
/// - A drag pans. With Ctrl, it zooms to the dragged range; with Shift, it selects the range.
/// - A click goes to the frame there. A double click shows the whole run.
/// - The arrow keys move the cursor; with Shift, they select a range.
/// - Page Up and Page Down pan. Home and End go to the first and the last frame.
/// - Return goes to the frame at the cursor, Backspace shows the whole run, and Escape clears the
///   range.
class PlotPointer : public QObject {
  Q_OBJECT
public:
  /// Creates the input for a plot. `axis` returns the axis shared by all plots, or null if there
  /// are no plots.
  PlotPointer(PlotNavigation& navigation, QCustomPlot* plot, std::function<QCPAxis*()> axis);

Q_SIGNALS:
  /// Emitted when the pointer, or the cursor moved by arrow keys, reaches this frame. A negative
  /// number means that it is on no frame.
  void frameHovered(qint64 frame);
  /// Emitted after each move of the pointer, with its position in the plot, and after each move of
  /// the cursor by keys, without a position. Not emitted during a drag.
  void cursorMoved(const std::optional<QPoint>& pointer);
  void frameChosen(qint64 frame);
  void rangeChosen(qint64 first, qint64 last);
  void rangeCleared();
  void contextMenuRequested(const QPoint& global);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  enum class Drag { None, Press, Pan, Zoom, Range };
  void press(QMouseEvent* event);
  void move(QMouseEvent* event);
  void release(QMouseEvent* event);
  bool handleKey(QKeyEvent* event);
  void stepFrames(std::int64_t frames, bool choosing);
  /// Returns false if the wheel is for the area around the plots.
  bool turnWheel(const QWheelEvent& wheel);
  void hover(std::optional<std::int64_t> frame);
  /// Returns the axis position or the frame at the horizontal plot pixel `x`.
  double keyAt(int x) const;
  std::optional<std::int64_t> frameAt(int x) const;

  PlotNavigation& navigation_;
  std::function<QCPAxis*()> axis_;
  Drag drag_ = Drag::None;
  QPoint pressed_;
  double pressedKey_ = 0.0;
  std::pair<double, double> pressedRange_;
  std::optional<std::int64_t> anchor_; ///< frame at which a range that is selected with keys begins
};

} // namespace dewpoint::ui

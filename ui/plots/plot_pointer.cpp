// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_pointer.h"

#include "ui/plots/plot_cursor.h"
#include "ui/plots/plot_row.h"
#include "ui/plots/plot_stack.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {
constexpr double kWheelZoom = 1.25; ///< per notch
constexpr double kKeyPan = 0.25;    ///< of the width
} // namespace

PlotPointer::PlotPointer(PlotStack& stack, QCustomPlot* plot) : QObject(plot), stack_(stack) {
  plot->installEventFilter(this);
}

bool PlotPointer::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
  case QEvent::MouseButtonPress:
    press(static_cast<QMouseEvent*>(event));
    return true;
  case QEvent::MouseMove:
    move(static_cast<QMouseEvent*>(event));
    return true;
  case QEvent::MouseButtonRelease:
    release(static_cast<QMouseEvent*>(event));
    return true;
  case QEvent::MouseButtonDblClick:
    drag_ = Drag::None;
    stack_.showAll();
    return true;
  case QEvent::Wheel: {
    const auto* wheel = static_cast<QWheelEvent*>(event);
    const double notches = wheel->angleDelta().y() / 120.0;
    if (notches != 0.0) {
      stack_.zoom(std::pow(kWheelZoom, notches), stack_.keyAt(wheel->position().toPoint().x()));
    } else {
      stack_.pan(-wheel->angleDelta().x() / 1200.0);
    }
    return true;
  }
  case QEvent::Leave:
    hover(std::nullopt);
    return false;
  case QEvent::ContextMenu:
    Q_EMIT stack_.contextMenuWanted(static_cast<QContextMenuEvent*>(event)->globalPos());
    return true;
  case QEvent::KeyPress:
    return key(static_cast<QKeyEvent*>(event));
  default:
    return false;
  }
}

void PlotPointer::hover(std::optional<std::int64_t> frame) {
  if (frame != stack_.hovered_) {
    stack_.setHovered(frame);
    Q_EMIT stack_.hovered(frame.value_or(-1));
  }
}

void PlotPointer::press(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    return;
  }
  pressed_ = event->pos();
  pressedKey_ = stack_.keyAt(pressed_.x());
  pressedRange_ = stack_.shownRange();
  anchor_.reset();
  drag_ = event->modifiers().testFlag(Qt::ShiftModifier)     ? Drag::Range
          : event->modifiers().testFlag(Qt::ControlModifier) ? Drag::Zoom
                                                             : Drag::Press;
}

void PlotPointer::move(QMouseEvent* event) {
  const auto here = event->pos();
  hover(stack_.frameAt(here.x()));
  if (drag_ == Drag::Press &&
      std::abs(here.x() - pressed_.x()) > QApplication::startDragDistance() / 2) {
    drag_ = Drag::Pan;
  }
  const double now = stack_.keyAt(here.x());
  if (drag_ == Drag::Pan && !stack_.rows_.empty()) {
    const double width = pressedRange_.second - pressedRange_.first;
    const int pixels = std::max(1, stack_.rows_.front()->rect()->width());
    const double moved = width * (pressed_.x() - here.x()) / pixels;
    stack_.showPart(pressedRange_.first + moved, pressedRange_.second + moved);
  } else if (drag_ == Drag::Zoom) {
    stack_.cursor_->dragged = std::minmax(pressedKey_, now);
    stack_.drawCursor();
  } else if (drag_ == Drag::Range) {
    const auto from = stack_.frameAt(pressed_.x());
    const auto to = stack_.frameAt(here.x());
    if (from && to) {
      const auto [first, last] = std::minmax(*from, *to);
      stack_.setSelectedRange(SelectedRange{first, last});
    }
  }
}

void PlotPointer::release(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    return;
  }
  const Drag was = std::exchange(drag_, Drag::None);
  stack_.cursor_->dragged.reset();
  if (was == Drag::Press) {
    if (const auto frame = stack_.frameAt(event->pos().x())) {
      Q_EMIT stack_.frameChosen(*frame);
    }
  } else if (was == Drag::Zoom && event->pos() != pressed_) {
    const auto [lower, upper] = std::minmax({pressedKey_, stack_.keyAt(event->pos().x())});
    stack_.showPart(lower, upper);
  } else if (was == Drag::Range && stack_.selectedRange_) {
    if (event->pos() == pressed_) {
      stack_.setSelectedRange(std::nullopt);
      Q_EMIT stack_.rangeCleared();
    } else {
      Q_EMIT stack_.rangeChosen(stack_.selectedRange_->first, stack_.selectedRange_->last);
    }
  }
  stack_.drawCursor();
}

bool PlotPointer::key(QKeyEvent* event) {
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
    return false;
  }
  constexpr std::int64_t kFar = std::int64_t{1} << 50;
  switch (event->key()) {
  case Qt::Key_Left:
    walk(-1, shift);
    return true;
  case Qt::Key_Right:
    walk(1, shift);
    return true;
  case Qt::Key_Home:
    walk(-kFar, shift);
    return true;
  case Qt::Key_End:
    walk(kFar, shift);
    return true;
  case Qt::Key_PageUp:
    stack_.pan(-kKeyPan);
    return true;
  case Qt::Key_PageDown:
    stack_.pan(kKeyPan);
    return true;
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    stack_.zoom(kWheelZoom);
    return true;
  case Qt::Key_Minus:
    stack_.zoom(1.0 / kWheelZoom);
    return true;
  case Qt::Key_Backspace:
    stack_.showAll();
    return true;
  case Qt::Key_Return:
  case Qt::Key_Enter:
    if (stack_.hovered_) {
      Q_EMIT stack_.frameChosen(*stack_.hovered_);
    }
    return true;
  case Qt::Key_Escape:
    anchor_.reset();
    hover(std::nullopt);
    stack_.setSelectedRange(std::nullopt);
    Q_EMIT stack_.rangeCleared();
    return true;
  default:
    return false;
  }
}

void PlotPointer::walk(std::int64_t frames, bool choosing) {
  const auto row = stack_.cursorRow();
  if (!row) {
    return;
  }
  const PlotSeries& series = *stack_.series_;
  const std::int64_t from = series.row(*row).frame;
  const std::int64_t to =
      std::clamp(from + frames, series.row(0).frame, series.row(series.size() - 1).frame);
  hover(to);
  if (!choosing) {
    anchor_.reset();
    return;
  }
  anchor_ = anchor_.value_or(from);
  const auto [first, last] = std::minmax(*anchor_, to);
  stack_.setSelectedRange(SelectedRange{first, last});
  Q_EMIT stack_.rangeChosen(first, last);
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_pointer.h"

#include "ui/plots/plot_navigation.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {
constexpr double kNotch = 120.0;    ///< of QWheelEvent::angleDelta()
constexpr double kWheelZoom = 1.25; ///< per notch
constexpr double kWheelPan = 0.1;   ///< of the width, per notch
constexpr double kKeyPan = 0.25;    ///< of the width
} // namespace

PlotPointer::PlotPointer(PlotNavigation& navigation, QCustomPlot* plot,
                         std::function<QCPAxis*()> axis)
    : QObject(plot), navigation_(navigation), axis_(std::move(axis)) {
  plot->installEventFilter(this);
}

double PlotPointer::keyAt(int x) const {
  const QCPAxis* axis = axis_();
  return axis != nullptr ? axis->pixelToCoord(x) : 0.0;
}

std::optional<std::int64_t> PlotPointer::frameAt(int x) const {
  const QCPAxis* axis = axis_();
  return axis != nullptr && x <= axis->axisRect()->right() ? navigation_.frameAt(keyAt(x))
                                                           : std::nullopt;
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
    navigation_.showWholeRun();
    return true;
  case QEvent::Wheel:
    // QCustomPlot accepts every turn of the wheel; ignored here, it goes on to the scroll area.
    event->setAccepted(turnWheel(*static_cast<QWheelEvent*>(event)));
    return true;
  case QEvent::ToolTip: // the label at the cursor is one
    return true;
  case QEvent::Leave:
    hover(std::nullopt);
    Q_EMIT cursorMoved(std::nullopt);
    return false;
  case QEvent::ContextMenu:
    Q_EMIT contextMenuRequested(static_cast<QContextMenuEvent*>(event)->globalPos());
    return true;
  case QEvent::KeyPress:
    return handleKey(static_cast<QKeyEvent*>(event));
  default:
    return false;
  }
}

bool PlotPointer::turnWheel(const QWheelEvent& wheel) {
  const QPoint turned = wheel.angleDelta();
  if (wheel.modifiers().testFlag(Qt::ControlModifier)) {
    navigation_.zoom(std::pow(kWheelZoom, turned.y() / kNotch),
                     keyAt(wheel.position().toPoint().x()));
    return true;
  }
  const bool isShifted = wheel.modifiers().testFlag(Qt::ShiftModifier);
  if (isShifted || std::abs(turned.x()) > std::abs(turned.y())) {
    navigation_.pan(-kWheelPan * (turned.x() != 0 ? turned.x() : turned.y()) / kNotch);
    return true;
  }
  return false;
}

void PlotPointer::hover(std::optional<std::int64_t> frame) {
  if (frame != navigation_.hoveredFrame()) {
    navigation_.setHoveredFrame(frame);
    Q_EMIT frameHovered(frame.value_or(-1));
  }
}

void PlotPointer::press(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    return;
  }
  pressed_ = event->pos();
  pressedKey_ = keyAt(pressed_.x());
  pressedRange_ = navigation_.shownRange();
  anchor_.reset();
  drag_ = event->modifiers().testFlag(Qt::ShiftModifier)     ? Drag::Range
          : event->modifiers().testFlag(Qt::ControlModifier) ? Drag::Zoom
                                                             : Drag::Press;
}

void PlotPointer::move(QMouseEvent* event) {
  const auto here = event->pos();
  hover(frameAt(here.x()));
  if (drag_ == Drag::None) {
    Q_EMIT cursorMoved(here);
  }
  if (drag_ == Drag::Press &&
      std::abs(here.x() - pressed_.x()) > QApplication::startDragDistance() / 2) {
    drag_ = Drag::Pan;
  }
  const double now = keyAt(here.x());
  if (const QCPAxis* axis = axis_(); drag_ == Drag::Pan && axis != nullptr) {
    const double width = pressedRange_.second - pressedRange_.first;
    const int pixels = std::max(1, axis->axisRect()->width());
    const double moved = width * (pressed_.x() - here.x()) / pixels;
    navigation_.showRange(pressedRange_.first + moved, pressedRange_.second + moved);
  } else if (drag_ == Drag::Zoom) {
    navigation_.setDraggedRange(std::minmax(pressedKey_, now));
  } else if (drag_ == Drag::Range) {
    const auto from = frameAt(pressed_.x());
    const auto to = frameAt(here.x());
    if (from && to) {
      const auto [first, last] = std::minmax(*from, *to);
      navigation_.setSelectedRange(SelectedRange{first, last});
    }
  }
}

void PlotPointer::release(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    return;
  }
  const Drag was = std::exchange(drag_, Drag::None);
  navigation_.setDraggedRange(std::nullopt);
  if (was == Drag::Press) {
    if (const auto frame = frameAt(event->pos().x())) {
      Q_EMIT frameChosen(*frame);
    }
  } else if (was == Drag::Zoom && event->pos() != pressed_) {
    const auto [lower, upper] = std::minmax({pressedKey_, keyAt(event->pos().x())});
    navigation_.showRange(lower, upper);
  } else if (was == Drag::Range && navigation_.selectedRange()) {
    if (event->pos() == pressed_) {
      navigation_.setSelectedRange(std::nullopt);
      Q_EMIT rangeCleared();
    } else {
      Q_EMIT rangeChosen(navigation_.selectedRange()->first, navigation_.selectedRange()->last);
    }
  }
}

bool PlotPointer::handleKey(QKeyEvent* event) {
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
    return false;
  }
  constexpr std::int64_t kFar = std::int64_t{1} << 50;
  switch (event->key()) {
  case Qt::Key_Left:
    stepFrames(-1, shift);
    return true;
  case Qt::Key_Right:
    stepFrames(1, shift);
    return true;
  case Qt::Key_Home:
    stepFrames(-kFar, shift);
    return true;
  case Qt::Key_End:
    stepFrames(kFar, shift);
    return true;
  case Qt::Key_PageUp:
    navigation_.pan(-kKeyPan);
    return true;
  case Qt::Key_PageDown:
    navigation_.pan(kKeyPan);
    return true;
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    navigation_.zoom(kWheelZoom);
    return true;
  case Qt::Key_Minus:
    navigation_.zoom(1.0 / kWheelZoom);
    return true;
  case Qt::Key_Backspace:
    navigation_.showWholeRun();
    return true;
  case Qt::Key_Return:
  case Qt::Key_Enter:
    if (const auto frame = navigation_.hoveredFrame()) {
      Q_EMIT frameChosen(*frame);
    }
    return true;
  case Qt::Key_Escape:
    anchor_.reset();
    hover(std::nullopt);
    Q_EMIT cursorMoved(std::nullopt);
    navigation_.setSelectedRange(std::nullopt);
    Q_EMIT rangeCleared();
    return true;
  default:
    return false;
  }
}

void PlotPointer::stepFrames(std::int64_t frames, bool choosing) {
  const auto row = navigation_.cursorRow();
  if (!row) {
    return;
  }
  const PlotSeries& series = *navigation_.series();
  const std::int64_t from = series.row(*row).frame;
  const std::int64_t to =
      std::clamp(from + frames, series.row(0).frame, series.row(series.size() - 1).frame);
  hover(to);
  Q_EMIT cursorMoved(std::nullopt);
  if (!choosing) {
    anchor_.reset();
    return;
  }
  anchor_ = anchor_.value_or(from);
  const auto [first, last] = std::minmax(*anchor_, to);
  navigation_.setSelectedRange(SelectedRange{first, last});
  Q_EMIT rangeChosen(first, last);
}

} // namespace dewpoint::ui

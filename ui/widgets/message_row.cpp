// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_row.h"

#include "ui/text/retranslation.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/notice_list.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QCursor>
#include <QDockWidget>
#include <QEvent>
#include <QLayout>
#include <QLineEdit>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QTimer>

#include <algorithm>

namespace dewpoint::ui {
namespace {

constexpr int kWatchMs = 250; ///< also the time in which a click ends that left the field
/// Without a key for so long, nobody types any more: a message need not cover the views longer.
constexpr int kQuietTicks = 5000 / kWatchMs;

/// Whether keys write into this widget.
bool isTextField(const QWidget* widget) {
  const auto* line = qobject_cast<const QLineEdit*>(widget);
  const auto* page = qobject_cast<const QPlainTextEdit*>(widget);
  const auto* choice = qobject_cast<const QComboBox*>(widget);
  return qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
         (line != nullptr && !line->isReadOnly()) || (page != nullptr && !page->isReadOnly()) ||
         (choice != nullptr && choice->isEditable());
}

/// Whether one who leaves a field for this widget goes on filling in a form.
bool isInForm(const QWidget* widget) {
  return isTextField(widget) || qobject_cast<const QComboBox*>(widget) != nullptr;
}

/// The dock that contains a widget; null outside of docks.
const QDockWidget* dockOf(const QWidget* widget) {
  while (widget != nullptr && qobject_cast<const QDockWidget*>(widget) == nullptr) {
    widget = widget->parentWidget();
  }
  return static_cast<const QDockWidget*>(widget);
}

} // namespace

MessageRow::MessageRow(MessageBar* bar, NoticeList* notices, QWidget* parent)
    : QToolBar(parent), bar_(bar), notices_(notices), watch_(new QTimer(this)) {
  setObjectName(QStringLiteral("messageRow"));
  onRetranslate(this, [this] { setWindowTitle(tr("Messages")); });
  setMovable(false);
  setFloatable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  watch_->setInterval(kWatchMs);
  connect(watch_, &QTimer::timeout, this, [this] {
    ++quietTicks_;
    fit();
  });
  qApp->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, &MessageRow::followFocus);
  for (QWidget* part : std::initializer_list<QWidget*>{bar, notices}) {
    part->setParent(parent); // not of the row, which they may exceed
    part->hide();
    part->installEventFilter(this);
  }
  takeNeededHeight();
}

int MessageRow::neededHeight(const QWidget* part) const {
  if (part == nullptr || part->isHidden() || part->layout() == nullptr) { // none: it ends
    return 0;
  }
  QLayout* layout = part->layout();
  layout->activate();
  return std::max(layout->minimumSize().height(), layout->hasHeightForWidth()
                                                      ? layout->heightForWidth(place().width())
                                                      : part->sizeHint().height());
}

int MessageRow::neededHeight() const {
  return neededHeight(bar_) + neededHeight(notices_);
}

QSize MessageRow::sizeHint() const {
  return {1, maximumHeight()};
}

QSize MessageRow::minimumSizeHint() const {
  return sizeHint();
}

bool MessageRow::keepsHeight(int wanted) const {
  if (QApplication::mouseButtons() != Qt::NoButton) {
    return true;
  }
  const QWidget* focus = QApplication::focusWidget();
  // A field that is left acts on its value before followFocus() is told of the next field.
  const bool goesOn = typedIn_ != nullptr && focus != nullptr && isInForm(focus);
  if (focus == nullptr || !(focus == typedIn_ || goesOn) || !focus->isVisible()) {
    return false;
  }
  if (wanted > maximumHeight()) {
    return isTextField(focus) && quietTicks_ < kQuietTicks;
  }
  // Empty room disturbs nobody, as long as one may go on to the next field. But if the pointer is
  // on the message, the user has closed it.
  const QRect room(mapToGlobal(QPoint(0, 0)), QSize(width(), maximumHeight()));
  return !room.contains(QCursor::pos());
}

void MessageRow::fit() {
  const int wanted = neededHeight();
  const bool keeps = wanted != maximumHeight() && keepsHeight(wanted);
  if (!keeps) {
    takeNeededHeight();
  }
  waitForQuiet(keeps);
  placeParts();
}

void MessageRow::takeNeededHeight() {
  const int wanted = neededHeight();
  if (wanted != maximumHeight()) {
    Q_EMIT heightAboutToChange();
    setFixedHeight(wanted);
    updateGeometry();
    Q_EMIT heightChanged();
  }
}

void MessageRow::waitForQuiet(bool waits) {
  if (waits == watch_->isActive()) {
    return;
  }
  quietTicks_ = 0;
  if (waits) {
    watch_->start();
  } else {
    watch_->stop();
  }
}

void MessageRow::followFocus(QWidget* before, QWidget* now) {
  const bool goesOn = before != nullptr && before == typedIn_ && now != nullptr && isInForm(now);
  typedIn_ = goesOn ? now : nullptr;
}

QRect MessageRow::place() const {
  const auto* window = qobject_cast<QMainWindow*>(parentWidget());
  if (maximumHeight() > 0 || window == nullptr) {
    return geometry();
  }
  // The window lays out no toolbar without height: it lies far outside.
  int top = window->menuWidget() != nullptr ? window->menuWidget()->geometry().bottom() + 1 : 0;
  for (const QToolBar* bar : window->findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) {
    if (bar != this && bar->isVisible() && !bar->isFloating() &&
        window->toolBarArea(bar) == Qt::TopToolBarArea) {
      top = std::max(top, bar->geometry().bottom() + 1);
    }
  }
  return {0, top, window->width(), 0};
}

void MessageRow::placeParts() {
  const QRect row = place();
  int top = row.y();
  for (QWidget* part : std::initializer_list<QWidget*>{bar_, notices_}) {
    if (const int needed = neededHeight(part); needed > 0) {
      part->setGeometry(row.x(), top, row.width(), needed);
      top += needed;
      if (top > row.y() + maximumHeight()) {
        part->raise(); // above the views
      }
    }
  }
}

void MessageRow::showEvent(QShowEvent* event) {
  QToolBar::showEvent(event);
  lower(); // below its parts
}

void MessageRow::moveEvent(QMoveEvent* event) {
  QToolBar::moveEvent(event);
  placeParts();
}

void MessageRow::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  fit();
}

bool MessageRow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    quietTicks_ = 0;
    if (QWidget* focus = QApplication::focusWidget();
        focus != nullptr && focus->window() == window() && isTextField(focus)) {
      typedIn_ = focus;
    }
  }
  if (event->type() == QEvent::Wheel && typedIn_ != nullptr) {
    // Who turns the wheel elsewhere, as to zoom an image, has left the form. The room goes now, not
    // after the press that begins a drag.
    const auto* under = qobject_cast<const QWidget*>(watched);
    if (under != nullptr && under->window() == window() && dockOf(under) != dockOf(typedIn_)) {
      typedIn_ = nullptr;
    }
  }
  if (watched != bar_ && watched != notices_) {
    return false;
  }
  switch (event->type()) {
  case QEvent::ShowToParent:
  case QEvent::HideToParent:
  case QEvent::LayoutRequest:
  case QEvent::FontChange:
    fit();
    break;
  default:
    break;
  }
  return QToolBar::eventFilter(watched, event);
}

} // namespace dewpoint::ui

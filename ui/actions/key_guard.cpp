// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/key_guard.h"

#include <QAction>
#include <QShortcutEvent>

#include <utility>

namespace dewpoint::ui {

KeyGuard::KeyGuard(QAction* action, std::function<bool()> ask)
    : QObject(action), ask_(std::move(ask)) {
  action->installEventFilter(this);
}

bool KeyGuard::eventFilter(QObject* /*watched*/, QEvent* event) {
  return event->type() == QEvent::Shortcut &&
         !static_cast<const QShortcutEvent*>(event)->isAmbiguous() && ask_();
}

} // namespace dewpoint::ui

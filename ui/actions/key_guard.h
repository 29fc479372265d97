// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

#include <functional>

class QAction;

namespace dewpoint::ui {

/// Asks for confirmation when the user presses the shortcut of a destructive action, because a key
/// is easily pressed by accident. Buttons and menu entries trigger the action immediately.
class KeyGuard : public QObject {
  Q_OBJECT
public:
  /// Creates a guard that lives as long as the action. When the shortcut is pressed, `ask` is
  /// called. If the user must confirm the action, `ask` shows the question and returns true, and
  /// the key press is ignored. Otherwise, `ask` returns false, and the action is triggered.
  KeyGuard(QAction* action, std::function<bool()> ask);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  std::function<bool()> ask_;
};

} // namespace dewpoint::ui

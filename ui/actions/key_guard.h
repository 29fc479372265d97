// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

#include <functional>

class QAction;

namespace dewpoint::ui {

/// Asks for confirmation before the shortcut of an action does damage. A key is pressed by accident
/// more easily than a button or a menu entry, so those act at once.
class KeyGuard : public QObject {
  Q_OBJECT
public:
  /// Calls `ask` when the shortcut is pressed. If `ask` returns false, no confirmation is needed
  /// and the action is triggered; if it returns true, the key press is ignored. The guard lives as
  /// long as the action.
  KeyGuard(QAction* action, std::function<bool()> ask);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  std::function<bool()> ask_;
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

#include <functional>

class QAction;

namespace dewpoint::ui {

/// Asks for confirmation when the user presses the shortcut of a destructive action. A key is
/// easily pressed by accident, so only shortcuts need confirmation. Buttons and menu entries
/// trigger the action immediately.
class KeyGuard : public QObject {
  Q_OBJECT
public:
  /// Calls `ask` when the shortcut is pressed. If `ask` returns false, no confirmation is needed
  /// and the action is triggered. If it returns true, the key press is ignored. The guard lives as
  /// long as the action.
  KeyGuard(QAction* action, std::function<bool()> ask);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  std::function<bool()> ask_;
};

} // namespace dewpoint::ui

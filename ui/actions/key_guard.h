// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

#include <functional>

class QAction;

namespace dewpoint::ui {

/// Asks before the key of an action does harm: a key is pressed by accident more easily than a
/// button or an entry of a menu, which act at once.
class KeyGuard : public QObject {
  Q_OBJECT
public:
  /// When the key is pressed, `ask` is called; the action is triggered only if that returns false:
  /// there is nothing to ask about. Lives as long as the action.
  KeyGuard(QAction* action, std::function<bool()> ask);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  std::function<bool()> ask_;
};

} // namespace dewpoint::ui

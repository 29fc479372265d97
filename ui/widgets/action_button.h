// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

class QAction;
class QToolButton;
class QWidget;

namespace dewpoint::ui {

/// A button that triggers an action, with its icon and hint, as long as both live: enabled and
/// checked as the action is. What stands on it is the caller's: a shorter word than in a menu.
QToolButton* makeActionButton(const char* name, QAction* action, QWidget* parent);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

class QAction;
class QToolButton;
class QWidget;

namespace dewpoint::ui {

/// Creates a button that triggers an action and shows its icon and hint while both exist. The
/// button follows the action's enabled and checked states. The caller sets its text, which is
/// shorter than the menu text.
QToolButton* makeActionButton(const char* name, QAction* action, QWidget* parent);

} // namespace dewpoint::ui

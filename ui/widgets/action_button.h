// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

class QAction;
class QToolButton;
class QWidget;

namespace dewpoint::ui {

/// Creates a button that triggers an action and shows the icon and the hint of the action. As long
/// as the action exists, the button follows its enabled and checked states. The caller sets its
/// text, which is shorter than the menu text.
QToolButton* makeActionButton(const char* name, QAction* action, QWidget* parent);

} // namespace dewpoint::ui

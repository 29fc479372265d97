// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

class QAction;
class QToolButton;
class QWidget;

namespace dewpoint::ui {

/// Creates a button that triggers an action and shows its icon and hint. While the action exists,
/// the button follows the action's enabled and checked states. The caller must set the text of the
/// button, which is shorter than the menu text.
QToolButton* makeActionButton(const char* name, QAction* action, QWidget* parent);

} // namespace dewpoint::ui

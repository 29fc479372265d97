// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {

struct Workbench;

/// Connects the actions of the menu *Help*.
void installHelp(const Workbench& bench);

/// Returns the manual page about what is in use now: the view with the keyboard focus, else the
/// open page, else the window as a whole.
QString manualPageInUse(const Workbench& bench);

} // namespace dewpoint::ui

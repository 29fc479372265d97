// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {

struct Workbench;

/// Connects the actions in the *Help* menu.
void installHelp(const Workbench& bench);

/// Opens *Report a problem* with the report that a crash left.
void reportCrash(const Workbench& bench, const QString& crash);

/// Returns the manual page for the part of the window that is in use: the view with the keyboard
/// focus, or else the open page, or else the window as a whole.
QString manualPageInUse(const Workbench& bench);

} // namespace dewpoint::ui

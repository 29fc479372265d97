// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {

struct Workbench;

/// Connects the actions of the menu *Help*.
void installHelp(const Workbench& bench);

/// The page of the manual about what is in use now: the view that has the keys, else the page or
/// the window as a whole.
QString manualPageInUse(const Workbench& bench);

} // namespace dewpoint::ui

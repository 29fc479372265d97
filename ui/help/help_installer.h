// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {

struct Workbench;

/// Connects the actions in the *Help* menu to the dialogs that they open.
void installHelp(const Workbench& bench);

/// Opens the dialog *Report a problem* with the crash report `crash`.
void openCrashReportDialog(const Workbench& bench, const QString& crash);

/// Returns the manual page about the part of the window in use: the view with the keyboard focus,
/// or else the open page, or else the whole window.
QString manualPageForFocusedView(const Workbench& bench);

} // namespace dewpoint::ui

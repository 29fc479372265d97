// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// Pages of the manual (files in docs/), in the order of the list.
QStringList manualPages();
/// Returns the page about a view, given the object name of its dock. `method`: the current method,
/// which selects the page for the parameter view. Returns the page about the window for a view
/// without its own page.
QString manualPageOf(const QString& dock, const QString& method);
/// Returns the page about a method, or about the default method if that page does not exist.
QString methodPageOf(const QString& method);

/// Folders where the pages may be; the first that contains them is used: beside an installed
/// program, in the source folder it was compiled from, and in the source folder that contains the
/// program.
QStringList manualFolders();
/// Returns the first of these folders that contains the pages; empty if there is none.
QString findManual(const QStringList& folders);

} // namespace dewpoint::ui

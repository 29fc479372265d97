// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// Returns the manual pages (files in docs/) in display order.
QStringList manualPages();
/// Returns the manual page about a view, given the object name of its dock. If a view has no page,
/// returns the page about the window. `method` is the current method; the parameter view shows the
/// page about this method.
QString manualPageOf(const QString& dock, const QString& method);
/// Returns the manual page about a method, or the page about the default method if the method has
/// none.
QString manualPageOfMethod(const QString& method);

/// Returns the folders in which to search for the manual pages, in this order: beside an installed
/// program, in the source folder from which the program was compiled, and in the source folder that
/// contains the program.
QStringList manualFolders();
/// Returns the first of `folders` that contains the manual pages, or an empty string if there is
/// none.
QString findManual(const QStringList& folders);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// Returns the manual pages (files in docs/) in display order.
QStringList manualPages();
/// Returns the page about a view, given the object name of its dock. `method` is the current
/// method, which selects the page for the parameter view. If a view has no page, returns the page
/// about the window.
QString manualPageOf(const QString& dock, const QString& method);
/// Returns the page about a method, or the page about the default method if there is no such page.
QString methodPageOf(const QString& method);

/// Returns the folders where the pages may be: beside an installed program, in the source folder it
/// was compiled from, and in the source folder that contains the program. The first folder that
/// contains the pages is used.
QStringList manualFolders();
/// Returns the first of these folders that contains the pages, or an empty string if there is none.
QString findManual(const QStringList& folders);

} // namespace dewpoint::ui

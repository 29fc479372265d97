// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// Pages of the manual, files of docs/, in the order in which they are listed.
QStringList manualPages();
/// The page about a view, by the object name of its dock; `method`: the one in use, for the view of
/// its parameters. The page about the window for a view that has none of its own.
QString manualPageOf(const QString& dock, const QString& method);
/// The page about a method; that of the default method when there is none.
QString methodPageOf(const QString& method);

/// Where the pages may lie, the first one that has them counts: beside an installed program, in the
/// folder of the sources that it was compiled from, and beside a program within such a folder.
QStringList manualFolders();
/// The first of these folders with the pages in it; empty when there is none.
QString findManual(const QStringList& folders);

} // namespace dewpoint::ui

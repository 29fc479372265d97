// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

class QWidget;

namespace dewpoint::ui {

// File dialogs that open in the folder used last and remember the folder of the selected file. The
// functions return an empty result if the user selects nothing.

/// Asks the user for an existing file, and returns its path; empty if none was selected.
QString askForFile(QWidget* parent, const QString& title, const QString& filter);
/// Asks the user for one or more existing files, and returns their paths; empty if none was
/// selected.
QStringList askForFiles(QWidget* parent, const QString& title, const QString& filter);
/// Asks the user for an existing folder, and returns its path; empty if none was selected.
QString askForFolder(QWidget* parent, const QString& title);
/// Asks the user for a file to save to, and returns its path; empty if none was selected.
/// `proposed` is a file name, with or without a folder.
QString askForFileToSave(QWidget* parent, const QString& title, const QString& proposed,
                         const QString& filter);

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

class QWidget;

namespace dewpoint::ui {

// File dialogs that start in the folder used last and remember the folder of the selected file.
// They return an empty result if nothing was selected.

/// Asks for an existing file.
QString askForFile(QWidget* parent, const QString& title, const QString& filter);
/// Asks for one or more existing files.
QStringList askForFiles(QWidget* parent, const QString& title, const QString& filter);
/// Asks for an existing folder.
QString askForFolder(QWidget* parent, const QString& title);
/// Asks for a file to save to. `proposed` is a file name, with or without a folder.
QString askForFileToSave(QWidget* parent, const QString& title, const QString& proposed,
                         const QString& filter);

} // namespace dewpoint::ui

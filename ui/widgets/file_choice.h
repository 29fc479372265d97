// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

class QWidget;

namespace dewpoint::ui {

// Dialogs for files that begin in the folder in which something was chosen last, and remember
// theirs. What they return is empty when nothing was chosen.

QString askForFile(QWidget* parent, const QString& title, const QString& filter);
QStringList askForFiles(QWidget* parent, const QString& title, const QString& filter);
QString askForFolder(QWidget* parent, const QString& title);
/// `proposed`: a name, or a file with its folder.
QString askForFileToSave(QWidget* parent, const QString& title, const QString& proposed,
                         const QString& filter);

} // namespace dewpoint::ui

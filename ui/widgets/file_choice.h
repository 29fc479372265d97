// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QStringList>

class QWidget;

namespace dewpoint::ui {

// File dialogs that start in the folder used last, and save their own. They return an empty result
// if nothing was selected.

QString askForFile(QWidget* parent, const QString& title, const QString& filter);
QStringList askForFiles(QWidget* parent, const QString& title, const QString& filter);
QString askForFolder(QWidget* parent, const QString& title);
/// `proposed`: a name, or a file with its folder.
QString askForFileToSave(QWidget* parent, const QString& title, const QString& proposed,
                         const QString& filter);

} // namespace dewpoint::ui

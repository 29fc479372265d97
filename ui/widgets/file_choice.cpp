// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/file_choice.h"

#include "ui/preferences/preferences.h"

#include <QDir>
#include <QFileDialog>

namespace dewpoint::ui {

namespace {

QString remembered(const QString& chosen) {
  if (!chosen.isEmpty()) {
    Preferences().setLastFolderOf(chosen);
  }
  return chosen;
}

} // namespace

QString askForFile(QWidget* parent, const QString& title, const QString& filter) {
  return remembered(
      QFileDialog::getOpenFileName(parent, title, Preferences().lastFolder(), filter));
}

QStringList askForFiles(QWidget* parent, const QString& title, const QString& filter) {
  const QStringList files =
      QFileDialog::getOpenFileNames(parent, title, Preferences().lastFolder(), filter);
  (void)remembered(files.value(0));
  return files;
}

QString askForFolder(QWidget* parent, const QString& title) {
  return remembered(QFileDialog::getExistingDirectory(parent, title, Preferences().lastFolder()));
}

QString askForFileToSave(QWidget* parent, const QString& title, const QString& proposed,
                         const QString& filter) {
  const QString folder = Preferences().lastFolder();
  const bool isName = !folder.isEmpty() && QDir::isRelativePath(proposed);
  return remembered(QFileDialog::getSaveFileName(
      parent, title, isName ? QDir(folder).filePath(proposed) : proposed, filter));
}

} // namespace dewpoint::ui

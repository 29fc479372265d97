// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/file_choice.h"

#include "ui/preferences/preferences.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace dewpoint::ui {

namespace {

/// The next dialog begins in the folder of the file. Dialogs return absolute paths: no disk is
/// asked.
QString remembered(const QString& file) {
  if (!file.isEmpty()) {
    Preferences().setLastFolder(QFileInfo(file).path());
  }
  return file;
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
  const QString folder =
      QFileDialog::getExistingDirectory(parent, title, Preferences().lastFolder());
  if (!folder.isEmpty()) {
    Preferences().setLastFolder(folder);
  }
  return folder;
}

QString askForFileToSave(QWidget* parent, const QString& title, const QString& proposed,
                         const QString& filter) {
  const QString folder = Preferences().lastFolder();
  const bool isName = !folder.isEmpty() && QDir::isRelativePath(proposed);
  return remembered(QFileDialog::getSaveFileName(
      parent, title, isName ? QDir(folder).filePath(proposed) : proposed, filter));
}

} // namespace dewpoint::ui

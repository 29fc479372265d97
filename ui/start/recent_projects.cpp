// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/recent_projects.h"

#include <QFileInfo>
#include <QSettings>

namespace dewpoint::ui {

namespace {

constexpr int kKept = 10;
const QString kKey = QStringLiteral("recentProjects");

} // namespace

QStringList recentProjects() {
  QStringList files;
  for (const QString& file : QSettings().value(kKey).toStringList()) {
    if (QFileInfo::exists(file)) {
      files.append(file);
    }
  }
  return files;
}

void addRecentProject(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  QStringList files = QSettings().value(kKey).toStringList();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue(kKey, QStringList(files.mid(0, kKept)));
}

void clearRecentProjects() {
  QSettings().remove(kKey);
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/recent_projects.h"

#include "ui/preferences/preferences.h"

#include <QFileInfo>

namespace dewpoint::ui {

RecentProjects::RecentProjects(QObject* parent)
    : QObject(parent), exists_([](const QString& file) { return QFileInfo::exists(file); }) {}

QStringList RecentProjects::files() const {
  QStringList files = Preferences().recentProjects();
  files.removeIf([this](const QString& file) { return missing_.contains(file); });
  return files;
}

void RecentProjects::add(const QString& file) {
  Preferences().addRecentProject(file);
  missing_.remove(Preferences().recentProjects().value(0));
  Q_EMIT changed();
}

void RecentProjects::clear() {
  Preferences().clearRecentProjects();
  Q_EMIT changed();
}

void RecentProjects::checkFiles() {
  const QStringList files = Preferences().recentProjects();
  if (files.isEmpty()) {
    return;
  }
  checking_.start([this, files, exists = exists_](const BackgroundJob::Progress&) {
    QSet<QString> missing;
    for (const QString& file : files) {
      if (!exists(file)) {
        missing.insert(file);
      }
    }
    return [this, missing] { applyResult(missing); };
  });
}

void RecentProjects::applyResult(const QSet<QString>& missing) {
  if (missing != missing_) {
    missing_ = missing;
    Q_EMIT changed();
  }
}

} // namespace dewpoint::ui

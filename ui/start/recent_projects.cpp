// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/recent_projects.h"

#include "ui/preferences/preferences.h"
#include "ui/start/project_thumbnails.h"

#include <QFileInfo>

namespace dewpoint::ui {

RecentProjects::RecentProjects(QObject* parent)
    : QObject(parent), exists_([](const QString& file) { return QFileInfo::exists(file); }) {}

std::vector<RecentProject> RecentProjects::allProjects() const {
  std::vector<RecentProject> all;
  for (const QString& file : Preferences().recentProjects()) {
    const auto known = known_.find(file);
    all.push_back(known == known_.end() ? RecentProject{.file = file} : known->second);
  }
  return all;
}

QStringList RecentProjects::openableFiles() const {
  QStringList files;
  for (const RecentProject& project : allProjects()) {
    if (!project.isMissing) {
      files << project.file;
    }
  }
  return files;
}

void RecentProjects::add(const QString& file) {
  Preferences().addRecentProject(file);
  if (const auto known = known_.find(Preferences().recentProjects().value(0));
      known != known_.end()) {
    known->second.isMissing = false;
  }
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
    Known known;
    for (const QString& file : files) {
      RecentProject& project = known[file];
      project.file = file;
      project.isMissing = !exists(file);
      if (!project.isMissing) {
        project.lastModified = QFileInfo(file).lastModified();
      }
      project.thumbnail = ProjectThumbnails::read(file);
    }
    return [this, known] { applyResult(known); };
  });
}

void RecentProjects::applyResult(const Known& known) {
  if (known != known_) {
    known_ = known;
    Q_EMIT changed();
  }
}

} // namespace dewpoint::ui

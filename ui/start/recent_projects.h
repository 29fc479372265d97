// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/latest_job.h"

#include <QDateTime>
#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace dewpoint::ui {

/// Recent project, and what is known about its file.
struct RecentProject {
  QString file;
  bool isMissing = false;      ///< the file does not exist
  QDateTime lastModified = {}; ///< time of the last save; invalid if unknown
  QImage thumbnail = {};       ///< see ProjectThumbnails; null for none

  bool operator==(const RecentProject&) const = default;
};

/// Manages the recent projects. Another thread checks whether their files exist, because the disk
/// may not respond. Until then, a file is assumed to exist.
class RecentProjects : public QObject {
  Q_OBJECT
public:
  /// Returns whether a file exists. Called from another thread.
  using Exists = std::function<bool(const QString& file)>;
  explicit RecentProjects(QObject* parent = nullptr);
  void setExistsCheck(Exists exists) { exists_ = std::move(exists); }

  /// Returns the files of the recent projects that can be opened, newest first.
  QStringList openableFiles() const;
  /// Returns all recent projects, newest first.
  std::vector<RecentProject> allProjects() const;
  /// Adds a project that was just opened or saved to the recent projects.
  void add(const QString& file);
  void clear();
  /// Checks in another thread whether the files of the recent projects exist. Emits `changed()` if
  /// the result differs from the previous one.
  void checkFiles();

Q_SIGNALS:
  void changed();

private:
  using Known = std::map<QString, RecentProject>;
  void applyResult(const Known& known);

  Exists exists_;
  Known known_;
  /// An unresponsive disk blocks at most one thread.
  LatestJob checking_{LatestJob::SupersededJob::Kept};
};

} // namespace dewpoint::ui

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

/// A project that was open last, with what is known of its file so far.
struct RecentProject {
  QString file;
  bool isMissing = false; ///< the file is gone
  QDateTime changed = {}; ///< when it was saved last; invalid: not known
  QImage thumbnail = {};  ///< see ProjectThumbnails; null: there is none

  bool operator==(const RecentProject&) const = default;
};

/// The projects that were open last. A thread finds out whether their files are there, as the disk
/// may not answer; until it does, a project is taken to be there.
class RecentProjects : public QObject {
  Q_OBJECT
public:
  /// Whether there is such a file; called in a thread.
  using Exists = std::function<bool(const QString& file)>;
  explicit RecentProjects(QObject* parent = nullptr);
  void setExists(Exists exists) { exists_ = std::move(exists); }

  /// Those that can be opened, the newest first.
  QStringList files() const;
  /// All of them, the newest first.
  std::vector<RecentProject> all() const;
  /// This one was opened or saved just now.
  void add(const QString& file);
  void clear();
  /// Finds out in a thread what there is to know of the files; changed() follows when it is
  /// something else than before.
  void checkFiles();

Q_SIGNALS:
  void changed();

private:
  using Known = std::map<QString, RecentProject>;
  void applyResult(const Known& known);

  Exists exists_;
  Known known_;
  LatestJob checking_{LatestJob::Overtaken::Kept}; ///< a dead disk holds one thread up and no more
};

} // namespace dewpoint::ui

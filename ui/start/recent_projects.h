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

/// A recent project and what is known of its file.
struct RecentProject {
  QString file;
  bool isMissing = false; ///< the file does not exist
  QDateTime changed = {}; ///< time of the last save; invalid: unknown
  QImage thumbnail = {};  ///< see ProjectThumbnails; null: none

  bool operator==(const RecentProject&) const = default;
};

/// Recent projects. Another thread checks whether their files exist, because the disk may not
/// respond; until then, a file is assumed to exist.
class RecentProjects : public QObject {
  Q_OBJECT
public:
  /// Whether a file exists; called in another thread.
  using Exists = std::function<bool(const QString& file)>;
  explicit RecentProjects(QObject* parent = nullptr);
  void setExists(Exists exists) { exists_ = std::move(exists); }

  /// Projects that can be opened, newest first.
  QStringList files() const;
  /// All projects, newest first.
  std::vector<RecentProject> all() const;
  /// Adds a project that was just opened or saved.
  void add(const QString& file);
  void clear();
  /// Checks the files in another thread; `changed()` follows if the result differs from the
  /// previous one.
  void checkFiles();

Q_SIGNALS:
  void changed();

private:
  using Known = std::map<QString, RecentProject>;
  void applyResult(const Known& known);

  Exists exists_;
  Known known_;
  /// An unresponsive disk blocks at most one thread.
  LatestJob checking_{LatestJob::Overtaken::Kept};
};

} // namespace dewpoint::ui

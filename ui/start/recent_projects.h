// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/latest_job.h"

#include <QObject>
#include <QSet>
#include <QString>
#include <QStringList>

#include <functional>
#include <utility>

namespace dewpoint::ui {

/// The projects that were open last, as they are offered: without those whose file is gone. A
/// thread finds out whether it is there, as its disk may not answer; until it does, the project is
/// offered.
class RecentProjects : public QObject {
  Q_OBJECT
public:
  /// Whether there is such a file; called in a thread.
  using Exists = std::function<bool(const QString& file)>;
  explicit RecentProjects(QObject* parent = nullptr);
  void setExists(Exists exists) { exists_ = std::move(exists); }

  /// Those that are offered, the newest first.
  QStringList files() const;
  /// This one was opened or saved just now.
  void add(const QString& file);
  void clear();
  /// Finds out in a thread which files are there; changed() follows when others are missing than
  /// before.
  void checkFiles();

Q_SIGNALS:
  void changed();

private:
  void applyResult(const QSet<QString>& missing);

  Exists exists_;
  QSet<QString> missing_;
  LatestJob checking_{LatestJob::Overtaken::Kept}; ///< a dead disk holds one thread up and no more
};

} // namespace dewpoint::ui

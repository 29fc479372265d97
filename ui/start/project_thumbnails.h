// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"

#include <QImage>
#include <QObject>
#include <QString>

#include <memory>

namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// Small pictures of projects, in the cache folder of the user: what the first camera of each saw
/// last. A project that is gone leaves one that takes about 5 kB.
class ProjectThumbnails : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// The picture of the project in this file; null when there is none. Any thread.
  static QImage read(const QString& projectFile);
  /// Makes it again in a thread of its own, of the first camera that has an image; kept() follows.
  void keep(const QString& projectFile, const TrackSnapshotPtr& shown);

Q_SIGNALS:
  void kept();

private:
  JobQueue queue_;
};

} // namespace dewpoint::ui

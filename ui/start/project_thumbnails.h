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

/// Project thumbnails in the user's cache folder: the last image of each project's first camera.
/// The thumbnail of a deleted project is kept; it takes about 5 kB.
class ProjectThumbnails : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// Returns the thumbnail of the project in this file, or null if there is none. May be called
  /// from any thread.
  static QImage read(const QString& projectFile);
  /// Writes the thumbnail of a project in another thread, from the first camera in the snapshot
  /// that has an image. Emits `saved()` afterward.
  void save(const QString& projectFile, const TrackSnapshotPtr& shown);

Q_SIGNALS:
  void saved();

private:
  JobQueue queue_;
};

} // namespace dewpoint::ui

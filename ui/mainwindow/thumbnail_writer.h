// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/start/project_thumbnails.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>

namespace dewpoint::ui {

/// Keeps a thumbnail of each project for the list of recent projects. The thumbnail is created when
/// the project is saved and when it is closed.
class ThumbnailWriter : public QObject {
  Q_OBJECT
public:
  explicit ThumbnailWriter(const Workbench& bench, QObject* parent);

  /// Creates the thumbnail from the last snapshot shown. Does nothing if the project has no file.
  void saveThumbnail();

Q_SIGNALS:
  void saved();

private:
  void onSnapshot(const TrackSnapshotPtr& snapshot);
  QString currentFile() const;

  Workbench bench_;
  TrackSnapshotPtr shown_; ///< last snapshot with images; null if none
  QString file_;           ///< file of the project that this snapshot belongs to
  ProjectThumbnails thumbnails_;
};

} // namespace dewpoint::ui

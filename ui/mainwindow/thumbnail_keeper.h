// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/start/project_thumbnails.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>

namespace dewpoint::ui {

/// Keeps a thumbnail of each project for the list of recent projects, made when the project is
/// saved and when it is closed.
class ThumbnailKeeper : public QObject {
  Q_OBJECT
public:
  explicit ThumbnailKeeper(const Workbench& bench, QObject* parent);

  /// Makes the thumbnail from the snapshot shown last. Does nothing if no file contains the
  /// project.
  void keep();

Q_SIGNALS:
  void kept();

private:
  void follow(const TrackSnapshotPtr& snapshot);
  QString fileNow() const;

  Workbench bench_;
  TrackSnapshotPtr shown_; ///< last snapshot with images; null: none
  QString file_;           ///< file of the project of that snapshot
  ProjectThumbnails thumbnails_;
};

} // namespace dewpoint::ui

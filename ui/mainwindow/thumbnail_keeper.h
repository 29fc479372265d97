// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/start/project_thumbnails.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>

namespace dewpoint::ui {

/// Keeps a small picture of each project for the list of recent ones: made when it is saved, and
/// when it is left.
class ThumbnailKeeper : public QObject {
  Q_OBJECT
public:
  explicit ThumbnailKeeper(const Workbench& bench, QObject* parent);

  /// Makes it of what was shown last; nothing when the project is in no file.
  void keep();

Q_SIGNALS:
  void kept();

private:
  void follow(const TrackSnapshotPtr& snapshot);
  QString fileNow() const;

  Workbench bench_;
  TrackSnapshotPtr shown_; ///< the last with images; null: none
  QString file_;           ///< of the project then
  ProjectThumbnails thumbnails_;
};

} // namespace dewpoint::ui

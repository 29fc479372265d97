// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/thumbnail_keeper.h"

#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/document/document.h"

namespace dewpoint::ui {

ThumbnailKeeper::ThumbnailKeeper(const Workbench& bench, QObject* parent)
    : QObject(parent), bench_(bench) {
  connect(&bench_.session, &SessionController::snapshotChanged, this, &ThumbnailKeeper::follow);
  connect(&thumbnails_, &ProjectThumbnails::kept, this, &ThumbnailKeeper::kept);
}

void ThumbnailKeeper::follow(const TrackSnapshotPtr& snapshot) {
  if (snapshot == nullptr) { // another project comes, or none
    keep();
    shown_.reset();
    return;
  }
  if (snapshot->frames != nullptr) {
    shown_ = snapshot;
    file_ = fileNow();
  }
}

QString ThumbnailKeeper::fileNow() const {
  return QString::fromStdString(bench_.document.project().file.string());
}

void ThumbnailKeeper::keep() {
  if (bench_.session.isRunning()) {
    file_ = fileNow(); // it may just have got one
  }
  if (!file_.isEmpty() && shown_ != nullptr) {
    thumbnails_.keep(file_, shown_);
  }
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/thumbnail_writer.h"

#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/document/document.h"

namespace dewpoint::ui {

ThumbnailWriter::ThumbnailWriter(const Workbench& bench, QObject* parent)
    : QObject(parent), bench_(bench) {
  connect(&bench_.session, &SessionController::snapshotChanged, this, &ThumbnailWriter::onSnapshot);
  connect(&thumbnails_, &ProjectThumbnails::saved, this, &ThumbnailWriter::saved);
}

void ThumbnailWriter::onSnapshot(const TrackSnapshotPtr& snapshot) {
  if (snapshot == nullptr) { // another project comes, or none
    saveThumbnail();
    shown_.reset();
    return;
  }
  if (snapshot->frames != nullptr) {
    shown_ = snapshot;
    file_ = currentFile();
  }
}

QString ThumbnailWriter::currentFile() const {
  return QString::fromStdString(bench_.document.project().file.string());
}

void ThumbnailWriter::saveThumbnail() {
  if (bench_.session.isRunning()) {
    file_ = currentFile(); // it may just have got one
  }
  if (!file_.isEmpty() && shown_ != nullptr) {
    thumbnails_.save(file_, shown_);
  }
}

} // namespace dewpoint::ui

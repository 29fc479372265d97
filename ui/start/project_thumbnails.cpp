// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/project_thumbnails.h"

#include "core/session/snapshot/snapshot.h"
#include "ui/style/image.h"

#include <QCryptographicHash>
#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>

namespace dewpoint::ui {

namespace {

/// Pixels: twice what lists show, for dense screens. Chosen.
constexpr QSize kThumbnailSize(160, 90);
constexpr int kThumbnailQuality = 85;

QString thumbnailFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
         QStringLiteral("/thumbnails");
}

QString thumbnailFile(const QString& projectFile) {
  const QByteArray name =
      QCryptographicHash::hash(projectFile.toUtf8(), QCryptographicHash::Sha1).toHex();
  return QStringLiteral("%1/%2.jpg").arg(thumbnailFolder(), QLatin1String(name));
}

/// The middle of an image, in the shape of a thumbnail.
QImage thumbnailOf(const cv::Mat& bgr) {
  const QImage scaled = toQImage(bgr).scaled(kThumbnailSize, Qt::KeepAspectRatioByExpanding,
                                             Qt::SmoothTransformation);
  return scaled.copy((scaled.width() - kThumbnailSize.width()) / 2,
                     (scaled.height() - kThumbnailSize.height()) / 2, kThumbnailSize.width(),
                     kThumbnailSize.height());
}

void writeThumbnail(const QString& projectFile, const FrameSet& frames) {
  for (const FramePtr& frame : frames.frames) {
    if (frame == nullptr || frame->image.empty()) {
      continue;
    }
    QSaveFile file(thumbnailFile(projectFile));
    // Without one there is an icon in the list: nobody needs to hear of it.
    if (QDir().mkpath(thumbnailFolder()) && file.open(QIODevice::WriteOnly) &&
        thumbnailOf(frame->image).save(&file, "JPG", kThumbnailQuality)) {
      file.commit();
    }
    return;
  }
}

} // namespace

QImage ProjectThumbnails::read(const QString& projectFile) {
  return QImage(thumbnailFile(projectFile));
}

void ProjectThumbnails::save(const QString& projectFile, const TrackSnapshotPtr& shown) {
  queue_.add([this, projectFile, frames = shown->frames] {
    if (frames != nullptr) {
      writeThumbnail(projectFile, *frames);
    }
    return [this] { Q_EMIT saved(); };
  });
}

} // namespace dewpoint::ui

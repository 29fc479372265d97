// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/background_image_taker.h"

#include "core/project/project.h"
#include "core/session/run/background_images.h"
#include "core/session/snapshot/snapshot_state.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/jobs/job_queue.h"
#include "ui/selection/selection.h"
#include "ui/text/error_sentence.h"

#include <QPointer>
#include <QStandardPaths>

#include <algorithm>

namespace dewpoint::ui {

namespace {

/// Whether an image that was taken of a camera is still wanted as its background image.
bool isStillAs(const ProjectCamera& now, const ProjectCamera& then) {
  return now.source == then.source && now.location == then.location &&
         now.backgroundImageFile == then.backgroundImageFile;
}

} // namespace

BackgroundImageTaker::BackgroundImageTaker(Document& document, Selection& selection,
                                           const CameraListModel& cameras, QObject* parent)
    : QObject(parent), document_(document), selection_(selection), cameras_(cameras),
      write_(saveBackgroundImage), writeQueue_(std::make_unique<JobQueue>()) {
  connect(&document_, &Document::projectReplaced, this, &BackgroundImageTaker::discardWrites);
}

BackgroundImageTaker::~BackgroundImageTaker() = default;

bool BackgroundImageTaker::canCapture(int camera) const {
  return !isWriting_ && !shownImage(camera).empty();
}

cv::Mat BackgroundImageTaker::shownImage(int camera) const {
  const auto row = static_cast<std::size_t>(std::max(0, camera));
  const bool any = snapshot_ && !snapshot_->isPreview && snapshot_->frames &&
                   row < snapshot_->frames->frames.size() && snapshot_->frames->frames[row];
  return any ? snapshot_->frames->frames[row]->image : cv::Mat();
}

QString BackgroundImageTaker::targetSeenBy(int camera) const {
  const TargetSnapshot* seen = snapshot_ ? trackedTargetInView(*snapshot_, camera) : nullptr;
  return seen != nullptr ? QString::fromStdString(seen->target.name) : QString();
}

void BackgroundImageTaker::capture(int camera) {
  const cv::Mat image = shownImage(camera);
  if (camera < 0 || image.empty()) {
    return;
  }
  if (const QString target = targetSeenBy(camera); !target.isEmpty()) {
    Q_EMIT confirmationRequested(
        tr("“%1” is visible in this image and would become part of the background. Choose a frame "
           "without this target.")
            .arg(target),
        tr("Use image anyway"), [this, camera, image, asked = QPointer(writeQueue_.get())] {
          if (asked && !isWriting_) { // else another project was opened meanwhile
            write(camera, image);
          }
        });
    return;
  }
  write(camera, image);
}

void BackgroundImageTaker::write(int camera, const cv::Mat& image) {
  const std::shared_ptr<const Project> project = document_.sharedProject();
  if (camera >= static_cast<int>(project->cameras.size())) {
    return; // there are fewer now
  }
  const QString own = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  const std::filesystem::path folder =
      project->file.empty() ? std::filesystem::path(own.toStdString()) / "empty-rooms"
                            : project->file.parent_path();
  selection_.selectCamera(camera);
  isWriting_ = true;
  Q_EMIT busyChanged();
  writeQueue_->add([this, write = write_, project, camera, image, folder] {
    return [this, project, camera,
            kept = write(*project, static_cast<std::size_t>(camera), image, folder)] {
      isWriting_ = false;
      Q_EMIT busyChanged();
      applyWritten(*project, camera, kept);
    };
  });
}

void BackgroundImageTaker::applyWritten(const Project& then, int camera,
                                        const Result<std::filesystem::path>& kept) {
  if (!kept) {
    Q_EMIT failed(errorText(kept.error()));
    return;
  }
  const auto row = static_cast<std::size_t>(camera);
  const QString file = QString::fromStdString(kept->string());
  const auto& cameras = document_.project().cameras;
  if (row >= cameras.size() || !isStillAs(cameras[row], then.cameras[row])) {
    Q_EMIT messageRequested(tr("The image was saved as %1, but is not used, because the settings "
                               "of the camera were changed in the meantime.")
                                .arg(file));
    return;
  }
  const auto edited = document_.edit(tr("Change background image"), [&](Project& project) {
    project.cameras[row].backgroundImageFile = kept->string();
  });
  if (!edited) {
    Q_EMIT failed(errorText(edited.error()));
    return;
  }
  Q_EMIT messageRequested(
      tr("The current image is now the background image of %1. It was saved as %2.")
          .arg(cameras_.nameOf(camera), file));
}

void BackgroundImageTaker::discardWrites() {
  writeQueue_ = std::make_unique<JobQueue>();
  isWriting_ = false;
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/video_drawer.h"

#include "core/session/session.h"
#include "ui/text/quantity_text.h"
#include "ui/view3d/birds_eye_view.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {

namespace {

/// The session counts frames from 0, people from 1.
Result<TrackSnapshotPtr> countedFromOne(Error error, std::int64_t frame) {
  if (error.code == ErrorCode::NotFound) {
    const QString text =
        QCoreApplication::translate("VideoDialog", "Frame %1").arg(frameNumberText(frame));
    error.detail = text.toStdString();
  }
  return tl::make_unexpected(std::move(error));
}

} // namespace

VideoDrawer::VideoDrawer(QObject* parent) : QObject(parent) {}

void VideoDrawer::beginVideo(Session* session, std::shared_ptr<const VideoLayout> look,
                             const BirdsEyeView* scene) {
  stop();
  session_ = session;
  look_ = std::move(look);
  sceneArea_ = -1;
  const auto& views = look_->views;
  const auto found = std::ranges::find_if(views, [](const VideoView& one) { return !one.camera; });
  if (scene == nullptr || found == views.end()) {
    return;
  }
  sceneArea_ = static_cast<int>(found - views.begin());
  scene_.copyAppearance(*scene, found->options.volume,
                        videoViewAreas(*look_)[static_cast<std::size_t>(sceneArea_)].size());
}

void VideoDrawer::stop() {
  ++generation_;
  fetching_ = false;
  session_ = nullptr;
}

void VideoDrawer::draw(std::int64_t frame, Consume consume, std::function<bool()> isWanted) {
  if (session_ == nullptr || fetching_) {
    return;
  }
  fetching_ = true;
  const auto receive = [this, mailbox = mailbox_.sender(), number = generation_, frame,
                        consume = std::move(consume)](Result<TrackSnapshotPtr> snapshot) {
    mailbox.post([this, number, frame, consume, snapshot = std::move(snapshot)] {
      if (number == generation_) {
        take(snapshot ? snapshot : countedFromOne(snapshot.error(), frame), consume);
      }
    });
  };
  session_->describeFrame({.frame = frame, .receive = receive, .isWanted = std::move(isWanted)});
}

void VideoDrawer::take(Result<TrackSnapshotPtr> snapshot, const Consume& consume) {
  QImage scene;
  int pause = 0; // so that the window has as much time as the scene took
  if (snapshot && sceneArea_ >= 0) {
    scene = scene_.draw(*snapshot);
    pause = static_cast<int>(std::ceil(scene_.lastDrawingMs()));
  }
  jobs_.add([look = look_, snapshot = std::move(snapshot), scene, consume] {
    return consume(snapshot ? Result<QImage>(videoPicture(*look, *snapshot, scene))
                            : Result<QImage>(tl::make_unexpected(snapshot.error())));
  });
  QTimer::singleShot(pause, this, [this, number = generation_] {
    if (number == generation_) {
      fetching_ = false;
      Q_EMIT ready();
    }
  });
}

} // namespace dewpoint::ui

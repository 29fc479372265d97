// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/world/board_floor.h"

#include "ui/document/document.h"
#include "ui/preferences/preferences.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"

#include <memory>

namespace dewpoint::ui {

namespace {

BoardDescription board() {
  return parseBoard(Preferences().boardPreferences({}).boardText.toStdString())
      .value_or(BoardDescription());
}

} // namespace

BoardFloor::BoardFloor(Document& document, QObject* parent)
    : QObject(parent), document_(document), job_(new BackgroundJob(this)) {
  connect(job_, &BackgroundJob::ended, this, &BoardFloor::changed);
  connect(&document_, &Document::projectReplaced, this, [this] {
    job_->cancel();
    resultText_.clear();
    Q_EMIT changed();
  });
}

QString BoardFloor::boardDescriptionText() {
  return QString::fromStdString(boardText(board()));
}

void BoardFloor::setSnapshot(const TrackSnapshotPtr& snapshot) {
  const bool had = frames_ != nullptr;
  frames_ = snapshot ? snapshot->frames : nullptr;
  if (had != (frames_ != nullptr)) {
    Q_EMIT changed();
  }
}

void BoardFloor::setFloorFromBoard() {
  if (!canSetFloor()) {
    return;
  }
  job_->start([this, project = document_.project(), description = board(),
               frames = frames_](const BackgroundJob::Progress&) -> std::function<void()> {
    const auto found =
        std::make_shared<Result<FloorFromBoard>>(withFloorFromBoard(project, description, *frames));
    return [this, project, found] { finish(project, *found); };
  });
  resultText_ = tr("Looking for the board in the images shown…");
  Q_EMIT changed();
}

void BoardFloor::finish(const Project& searched, const Result<FloorFromBoard>& found) {
  if (!found) {
    resultText_ =
        found.error().code == ErrorCode::NotFound
            ? tr("No camera sees the board well enough: %1. Show images in which the board lies on "
                 "the floor, or correct the description of the board on the page Board.")
                  .arg(boardDescriptionText())
            : errorText(found.error());
    return;
  }
  if (!(document_.project().cameras == searched.cameras)) {
    resultText_ =
        tr("The floor was not set, because the cameras have changed in the meantime. Try again.");
    return;
  }
  const auto edited = document_.edit(tr("Set the floor from the board"),
                                     [&](Project& changed) { changed = found->project; });
  resultText_ = edited
                    ? tr("The floor is set from the board, which %n camera(s) can see (error %1). "
                         "The world was rotated by %2.",
                         nullptr, static_cast<int>(found->cameraCount))
                          .arg(pixelText(found->rmsPx, 2), angleText(found->rotationAngle, 1))
                    : errorText(edited.error());
}

} // namespace dewpoint::ui

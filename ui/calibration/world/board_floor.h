// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/session/snapshot/snapshot.h"
#include "core/setup/calibration/floor_from_board.h"
#include "ui/jobs/background_job.h"

#include <QObject>
#include <QString>

namespace dewpoint::ui {

class Document;

/// Sets the floor and the origin of the world frame from a board that lies on the floor in the
/// images shown. The page *Board* describes the board. The change is one undoable step of the
/// document.
class BoardFloor : public QObject {
  Q_OBJECT
public:
  explicit BoardFloor(Document& document, QObject* parent = nullptr);

  /// Sets the snapshot whose images are searched for the board.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Returns whether images are shown and no search is running.
  bool canSetFloor() const { return frames_ != nullptr && !job_->isRunning(); }
  bool isRunning() const { return job_->isRunning(); }
  /// Searches the images shown for the board, and sets the floor if it is found.
  void setFloorFromBoard();
  /// Returns a sentence about the last search, or an empty string.
  const QString& resultText() const { return resultText_; }
  /// Returns the description of the board, in the form used on the command line.
  static QString boardDescriptionText();

Q_SIGNALS:
  void changed();

private:
  void finish(const Project& searched, const Result<FloorFromBoard>& found);

  Document& document_;
  BackgroundJob* job_;
  FrameSetPtr frames_;
  QString resultText_;
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/setup/board_watch.h"
#include "ui/jobs/job_thread.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>

namespace dewpoint::ui {

class Document;
struct BoardPreferences;
class BackgroundJob;

/// Calibrating with a board: the user's settings, the search in a recording or the guidance before
/// live cameras, and the result, which becomes one step of the document.
class BoardCalibrator : public QObject {
  Q_OBJECT
public:
  /// Opens the document's recording once more; called in a thread.
  using Opener = std::function<Result<SessionInputs>(const SessionRequest&)>;
  BoardCalibrator(Document& document, Opener open, QObject* parent = nullptr);
  ~BoardCalibrator() override;

  /// Remembered for the next time, besides the frame of the floor.
  const BoardGuideRequest& request() const { return request_; }
  void setRequest(const BoardGuideRequest& request);
  const Project& project() const;
  /// "camera 2" where it has no name.
  QString nameOf(std::size_t camera) const;

  void setSnapshot(const TrackSnapshotPtr& snapshot);
  bool isLive() const { return live_; }
  /// The frame shown, -1 before there is one.
  qint64 shownFrame() const { return shownFrame_; }

  // A recording.
  void calibrate();
  void cancel();
  /// Whether something is computed: a recording, or the result of live cameras.
  bool isComputing() const;
  /// Whether the recording is being searched, and nothing solved yet.
  bool isLooking() const { return *looking_; }

  // Live cameras.
  void start(); ///< or starts over
  void stop();
  bool isWatching() const { return watching_; }
  void captureNow() { watch_->captureNow(); }
  void captureFloor() { watch_->captureFloor(); }
  void goOn() { watch_->goOn(); }
  /// Calibrates from what was taken so far, and ends the guidance.
  void finish();
  /// The newest state of the guidance; never null.
  BoardGuideStatePtr guide() const { return watch_->newest(); }
  /// Whether anything was taken.
  bool hasViews() const;

  // What came of it.
  /// The last calibration; null before there was one, and after a failure.
  std::shared_ptr<const BoardOutcome> outcome() const { return outcome_; }
  /// One sentence, when it was none.
  const QString& failure() const { return failure_; }
  /// Whether the project's cameras are those of the outcome.
  bool isApplied() const;
  void apply();
  /// Writes the report (HTML) in a thread; saved() or failed() follow.
  void saveReport(const QString& file);
  /// Writes the board (PDF) likewise.
  void printBoard(const QString& paper, const QString& file);

Q_SIGNALS:
  void requestChanged();
  void changed(); ///< of everything else
  void guideChanged();
  void progressChanged(double part); ///< 0 to 1; less: unknown
  void calibrated();                 ///< over, whatever came of it
  void playWanted();                 ///< live images are needed
  void boardShown(bool shown);       ///< to live cameras, from now on (or no more)
  void saved(const QString& file);
  void failed(const QString& sentence);

private:
  using Computation = std::function<Result<BoardOutcome>(const CalibrationProgress& progress)>;
  void setWatching(bool watching);
  void compute(Computation computation, bool applyIt);
  void applyResult(const std::shared_ptr<Result<BoardOutcome>>& result, bool applyIt);
  void write(const std::function<Status()>& task, const QString& file);
  void forget();
  std::function<void()> wakeUp();
  BoardPreferences preferences() const;
  void recall();

  Document& document_;
  Opener open_;
  BoardGuideRequest request_;
  bool live_ = false;
  bool watching_ = false;
  qint64 shownFrame_ = -1;
  FrameSetPtr shownToWatch_;
  std::shared_ptr<const BoardOutcome> outcome_;
  QString failure_;
  bool forgotten_ = false; ///< what is computed is of another project
  std::shared_ptr<std::atomic<bool>> looking_;
  BackgroundJob* job_; ///< children: end with the calibrator
  BackgroundJob* writer_;
  JobMailbox mailbox_;                                ///< what the watch's thread has seen
  std::unique_ptr<BoardWatch, DetachedDelete> watch_; ///< its thread ends beside the window
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/setup/calibration/board_watch.h"
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

/// Calibration with a board. Holds the settings of the user, searches a recording for the board or
/// guides the user in front of live cameras, and applies the result as one step of the document.
class BoardCalibrator : public QObject {
  Q_OBJECT
public:
  /// Opens the recording of the document a second time; called in another thread.
  using Opener = std::function<Result<SessionInputs>(const SessionRequest&)>;
  BoardCalibrator(Document& document, Opener open, QObject* parent = nullptr);
  ~BoardCalibrator() override;

  /// Settings, saved in the preferences except for the frame of the floor.
  const BoardGuideRequest& request() const { return request_; }
  void setRequest(const BoardGuideRequest& request);
  const Project& project() const;
  /// Returns the name of a camera, or "camera 2" if it has none.
  QString nameOf(std::size_t camera) const;

  void setSnapshot(const TrackSnapshotPtr& snapshot);
  bool isLive() const { return live_; }
  /// Number of the frame shown; -1 before the first one.
  qint64 shownFrame() const { return shownFrame_; }

  // A recording.
  void calibrate();
  void cancel();
  /// Whether a computation is running: on a recording, or on the views of live cameras.
  bool isComputing() const;
  /// Whether the recording is still being searched for the board, before solving starts.
  bool isLooking() const { return *looking_; }

  // Live cameras.
  void start(); ///< starts the guidance, or starts it over
  void stop();
  bool isWatching() const { return watching_; }
  void captureNow() { watch_->captureNow(); }
  void captureFloor() { watch_->captureFloor(); }
  void goOn() { watch_->goOn(); }
  /// Calibrates from the views captured so far and ends the guidance.
  void finish();
  /// Newest state of the guidance; never null.
  BoardGuideStatePtr guide() const { return watch_->newest(); }
  /// Whether any view has been captured.
  bool hasViews() const;

  // The result.
  /// The last calibration; null before the first one and after a failure.
  std::shared_ptr<const BoardOutcome> outcome() const { return outcome_; }
  /// One sentence that explains why the last calibration failed.
  const QString& failure() const { return failure_; }
  /// Whether the cameras of the project are those of the outcome.
  bool isApplied() const;
  void apply();
  /// Writes the HTML report in another thread; `saved()` or `failed()` follows.
  void saveReport(const QString& file);
  /// Writes the board as a PDF in another thread; `saved()` or `failed()` follows.
  void printBoard(const QString& paper, const QString& file);

Q_SIGNALS:
  void requestChanged();
  void changed(); ///< anything else has changed
  void guideChanged();
  void progressChanged(double part); ///< 0 to 1; negative: unknown
  void calibrated();                 ///< the computation has ended, with or without a result
  void playWanted();                 ///< live images are needed
  void boardShown(bool shown);       ///< whether the board is now being shown to live cameras
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
  bool forgotten_ = false; ///< the running computation belongs to an earlier project
  std::shared_ptr<std::atomic<bool>> looking_;
  BackgroundJob* job_; ///< child of the calibrator; ends with it
  BackgroundJob* writer_;
  JobMailbox mailbox_; ///< results from the thread of the watch
  /// its thread may end after the window closes
  std::unique_ptr<BoardWatch, DetachedDelete> watch_;
};

} // namespace dewpoint::ui

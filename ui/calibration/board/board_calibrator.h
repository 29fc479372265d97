// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/setup/calibration/board_guide_thread.h"
#include "core/setup/calibration/board_recording.h"
#include "ui/jobs/job_thread.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::ui {

class Document;
struct BoardPreferences;
class BackgroundJob;

/// Board calibration. Holds the user's settings, searches a recording for the board or guides the
/// user in front of live cameras, and applies the result to the project in one undoable step.
class BoardCalibrator : public QObject {
  Q_OBJECT
public:
  /// Function that opens the recording of the document a second time. Called from another thread.
  using Opener = std::function<Result<SessionInputs>(const SessionRequest&)>;
  BoardCalibrator(Document& document, Opener open, QObject* parent = nullptr);
  ~BoardCalibrator() override;

  /// Returns the user's settings. All settings are saved in the preferences, except the frame in
  /// which the board lies on the floor.
  const BoardGuideRequest& guideRequest() const { return request_; }
  void setGuideRequest(const BoardGuideRequest& request);
  const Project& project() const;
  /// Returns the name of a camera, or "camera 2" if it has none.
  QString nameOf(std::size_t camera) const;

  void setSnapshot(const TrackSnapshotPtr& snapshot);
  bool usesLiveCameras() const { return live_; }
  /// Returns the number of the frame shown, or -1 before the first frame.
  qint64 shownFrame() const { return shownFrame_; }

  // Calibration from a recording.
  void calibrate();
  /// Calibrates from the recording like calibrate(), but searches all frames, even if the first
  /// frames searched show another board than the one in the settings.
  void searchAllFrames();
  void cancel();
  /// Returns whether a computation is running, either on a recording or on views from live cameras.
  bool isComputing() const;
  /// Returns whether the recording is still being searched for the board. Solving starts after the
  /// search.
  bool isSearchingRecording() const { return *searching_; }

  // Any board.
  /// Determines which board the recording, or the newest live images, show. The result is reported
  /// by one of the signals boardProposed(), boardConfirmed() and mirroredVideosFound(), or as a
  /// sentence in failureText().
  void identifyBoard();
  /// Returns the board that the images show instead of the one in the settings, if one was found.
  const std::optional<BoardGuess>& proposal() const { return proposal_; }
  /// Sets the board in the settings to the board that the images show (proposal()).
  void useProposal();
  /// Returns the cameras in whose images the last search found the board only mirrored.
  const MirroredVideos& mirroredVideos() const { return mirrored_; }
  /// Mirrors the images of the cameras in mirroredVideos() in the project, in one undoable step,
  /// and uses the proposed board.
  void mirrorImages();

  // Live cameras.
  void startGuidance(); ///< starts or restarts the guidance of the user in front of live cameras
  void stopGuidance();
  bool isGuiding() const { return watching_; }
  void captureNow() { watch_->captureNow(); }
  void captureFloor() { watch_->captureFloor(); }
  void skipToPoses() { watch_->skipToPoses(); }
  /// Calibrates from the views captured so far and ends the guidance.
  void calibrateFromCapturedViews();
  /// Returns the newest state of the guidance in front of live cameras; never null.
  BoardGuideStatePtr guideState() const { return watch_->newestState(); }
  /// Returns whether any view has been captured.
  bool hasCapturedViews() const;

  // The result.
  /// Returns the result of the last calibration; null before the first one and after a failure.
  std::shared_ptr<const BoardOutcome> outcome() const { return outcome_; }
  /// Returns one sentence that explains why the last calibration failed.
  const QString& failureText() const { return failure_; }
  /// Returns whether the project's cameras are those of the last calibration.
  bool isApplied() const;
  void apply();
  /// Writes the HTML report in another thread; emits `saved()` or `failed()` afterwards.
  void saveReport(const QString& file);
  /// Writes the board as PDF in another thread; emits `saved()` or `failed()` afterwards.
  void printBoard(const QString& paper, const QString& file);

Q_SIGNALS:
  void guideRequestChanged();
  void changed(); ///< emitted when anything except the settings and the guidance has changed
  void guideChanged();
  /// Emitted with the progress of the calibration, 0 to 1; negative if unknown.
  void progressChanged(double fraction);
  void calibrationEnded(); ///< emitted when a calibration has ended, with or without a result
  /// Emitted when images show another board than the one in the settings; proposal() returns this
  /// board. `stopped` is true if a calibration ended early for this reason.
  void boardProposed(bool stopped);
  /// Emitted when some cameras show the board mirrored; see mirroredVideos().
  void mirroredVideosFound();
  /// Emitted when `imageCount` of `searchedImageCount` images show the board in the settings.
  void boardConfirmed(int imageCount, int searchedImageCount);
  void playRequested(); ///< emitted when live images are needed, so that the run must play
  void boardVisibilityChanged(
      bool shown); ///< whether the board is currently being shown to live cameras
  void saved(const QString& file);
  /// Emitted after saved() if the printed board is split over several sheets of paper.
  void printedOnSeveralSheets(const QString& file, int sheetCount);
  void failed(const QString& sentence);

private:
  using Proposal = Result<BoardRecordingProposal>;
  using Computation = std::function<BoardRecordingCalibration(const CalibrationProgress& progress)>;
  void calibrateRecording(bool checksForOtherBoardFirst);
  void setWatching(bool watching);
  /// Calibrates if the user has shown all views that the guidance asked for.
  void finishWhenGuided();
  void compute(Computation computation, bool applyIt);
  void applyResult(const std::shared_ptr<BoardRecordingCalibration>& computed, bool applyIt);
  void takeGuesses(const Proposal& proposed);
  void write(const std::function<Status()>& task, const QString& file, int sheets = 1);
  void discardResults();
  std::function<void()> wakeUp();
  BoardPreferences preferences() const;
  void loadPreferences();

  Document& document_;
  Opener open_;
  BoardGuideRequest request_;
  bool live_ = false;
  bool watching_ = false;
  qint64 shownFrame_ = -1;
  FrameSetPtr lastWatchedFrames_;
  FrameSetPtr liveFrames_; ///< newest images of live cameras
  std::shared_ptr<const BoardOutcome> outcome_;
  QString failure_;
  std::optional<BoardGuess> proposal_;
  MirroredVideos mirrored_;
  bool outdated_ = false; ///< the running computation belongs to a previous project
  std::shared_ptr<std::atomic<bool>> searching_;
  BackgroundJob* job_; ///< child of the calibrator, which deletes it
  BackgroundJob* writer_;
  JobMailbox mailbox_; ///< receives the states of the guidance from the thread of `watch_`
  /// Guidance in front of live cameras. It runs in a thread that may outlive the window.
  std::unique_ptr<BoardGuideThread, DetachedDeleter> watch_;
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/board_calibrator.h"

#include "core/base/text_file.h"
#include "core/calibration/board/board_print.h"
#include "ui/document/document.h"
#include "ui/jobs/background_job.h"
#include "ui/preferences/preferences.h"
#include "ui/text/camera_names.h"
#include "ui/text/error_sentence.h"

#include <algorithm>
#include <utility>

namespace dewpoint::ui {
namespace {

constexpr double kLookingShare = 0.85; ///< of the time that a recording takes

} // namespace

BoardCalibrator::BoardCalibrator(Document& document, Opener open, QObject* parent)
    : QObject(parent), document_(document), open_(std::move(open)),
      searching_(std::make_shared<std::atomic<bool>>(false)), job_(new BackgroundJob(this)),
      writer_(new BackgroundJob(this)), watch_(new BoardGuideThread(wakeUp())) {
  request_.goal = {true, true};
  loadPreferences();
  connect(job_, &BackgroundJob::progressChanged, this, &BoardCalibrator::progressChanged);
  connect(job_, &BackgroundJob::ended, this, [this](bool canceled) {
    if (canceled && !std::exchange(outdated_, false)) {
      failure_ = tr("Stopped. The previous calibration is kept.");
    }
    Q_EMIT changed();
    Q_EMIT calibrationEnded();
    finishWhenGuided(); // the guidance may have ended while a board was being found
  });
  connect(&document_, &Document::projectReplaced, this, &BoardCalibrator::discardResults);
  connect(&document_, &Document::sourcesChanged, this, &BoardCalibrator::discardResults);
  connect(&document_, &Document::calibrationChanged, this, &BoardCalibrator::changed);
}

BoardCalibrator::~BoardCalibrator() = default;

const Project& BoardCalibrator::project() const {
  return document_.project();
}

QString BoardCalibrator::nameOf(std::size_t camera) const {
  const auto& cameras = project().cameras;
  return cameraName(camera < cameras.size() ? cameras[camera].camera.name : std::string(), camera);
}

void BoardCalibrator::setGuideRequest(const BoardGuideRequest& request) {
  request_ = request;
  Preferences().setBoardPreferences(preferences());
  if (watching_) {
    startGuidance(); // what was taken is of another board, or for another lens
  }
  Q_EMIT guideRequestChanged();
}

BoardPreferences BoardCalibrator::preferences() const {
  return {QString::fromStdString(boardText(request_.board.board)),
          static_cast<int>(request_.board.model),
          request_.goal.estimatesLenses,
          request_.goal.estimatesPoses,
          request_.lensGuidance.requiredProjectionSigmaPx,
          request_.requiredPositionSigma};
}

void BoardCalibrator::loadPreferences() {
  BoardPreferences atFirst = preferences();
  atFirst.calibratesIntrinsics = true;
  atFirst.calibratesPositions = true;
  const BoardPreferences kept = Preferences().boardPreferences(atFirst);
  if (const auto board = parseBoard(kept.boardText.toStdString())) {
    request_.board.board = *board;
  }
  request_.board.model = static_cast<IntrinsicsModel>(std::clamp(kept.lensModel, 0, 2));
  request_.goal.estimatesLenses = kept.calibratesIntrinsics;
  request_.goal.estimatesPoses = kept.calibratesPositions || !request_.goal.estimatesLenses;
  request_.lensGuidance.requiredProjectionSigmaPx = kept.intrinsicsAccuracyPx;
  request_.requiredPositionSigma = kept.positionAccuracyMeters;
}

void BoardCalibrator::setSnapshot(const TrackSnapshotPtr& snapshot) {
  const bool live = snapshot && snapshot->frames && !snapshot->frameCount;
  const bool first = shownFrame_ < 0;
  shownFrame_ = snapshot ? snapshot->frame : -1;
  liveFrames_ = live ? snapshot->frames : nullptr;
  if (live && watching_ && !snapshot->isPast && snapshot->frames != lastWatchedFrames_) {
    lastWatchedFrames_ = snapshot->frames;
    watch_->offer(snapshot->frames);
  }
  if (live != live_ || first != (shownFrame_ < 0)) {
    live_ = live;
    Q_EMIT changed();
  }
}

bool BoardCalibrator::isComputing() const {
  return job_->isRunning();
}

void BoardCalibrator::compute(Computation computation, bool applyIt) {
  outcome_.reset();
  failure_.clear();
  proposal_.reset();
  mirrored_ = {};
  job_->start([this, computation = std::move(computation), looking = searching_,
               applyIt](const BackgroundJob::Progress& progress) -> std::function<void()> {
    auto computed = std::make_shared<BoardRecordingCalibration>(
        computation([&](CalibrationStage stage, double part) {
          *looking = stage == CalibrationStage::BoardDetection;
          return progress(*looking ? kLookingShare * part : -1.0);
        }));
    *looking = false;
    return [this, computed, applyIt] { applyResult(computed, applyIt); };
  });
  Q_EMIT changed();
}

void BoardCalibrator::applyResult(const std::shared_ptr<BoardRecordingCalibration>& computed,
                                  bool applyIt) {
  proposal_ = computed->otherBoard;
  mirrored_ = computed->mirroredVideos;
  if (mirrored_.cause != MirroredVideos::Cause::None) {
    Q_EMIT mirroredVideosFound();
  } else if (proposal_) {
    Q_EMIT boardProposed(!computed->hasSearchedAllFrames);
  }
  if (!computed->outcome) {
    failure_ = errorText(computed->outcome.error());
    return;
  }
  outcome_ = std::make_shared<const BoardOutcome>(std::move(*computed->outcome));
  if (applyIt && !isDoubtful(*outcome_)) {
    apply();
  }
}

void BoardCalibrator::calibrate() {
  calibrateRecording(true);
}

void BoardCalibrator::searchAllFrames() {
  calibrateRecording(false);
}

void BoardCalibrator::calibrateRecording(bool checksForOtherBoardFirst) {
  if (isComputing() || live_) {
    return;
  }
  *searching_ = true;
  BoardGuideRequest request = request_;
  request.board.checksForOtherBoardFirst = checksForOtherBoardFirst;
  compute(
      [open = open_, project = project(), request](const CalibrationProgress& progress) {
        const auto inputs = open(project);
        return inputs ? calibrateFromBoardRecording(inputs->project, *inputs->source, request.board,
                                                    request.goal, progress)
                      : BoardRecordingCalibration{tl::make_unexpected(inputs.error())};
      },
      true);
}

void BoardCalibrator::identifyBoard() {
  if (isComputing() || shownFrame_ < 0) {
    return;
  }
  *searching_ = true;
  failure_.clear();
  proposal_.reset();
  job_->start(
      [this, open = open_, project = project(), frames = liveFrames_, board = request_.board.board,
       looking = searching_](const BackgroundJob::Progress& progress) -> std::function<void()> {
        const CalibrationProgress report = [&](CalibrationStage, double part) {
          return progress(part);
        };
        // One frame of live images is too little to know which videos are mirrored.
        auto proposed = std::make_shared<Proposal>(
            frames != nullptr
                ? proposeBoards(*frames, board, report).map([](std::vector<BoardGuess> guesses) {
                    return BoardRecordingProposal{std::move(guesses), MirroredVideos()};
                  })
                : open(project).and_then([&](const SessionInputs& inputs) {
                    return proposeBoardsAndMirroredVideos(*inputs.source, board,
                                                          kBoardProposalFrames, report);
                  }));
        *looking = false;
        return [this, proposed] { takeGuesses(*proposed); };
      });
  Q_EMIT changed();
}

void BoardCalibrator::takeGuesses(const Proposal& proposed) {
  if (!proposed) {
    failure_ = proposed.error().code == ErrorCode::NotFound
                   ? tr("No board was found. Show the whole board in focus and in even light, then "
                        "press Find board again.")
                   : errorText(proposed.error());
    return;
  }
  const BoardGuess& best = proposed->guesses.front();
  const MirroredVideos mirrored = proposed->mirroredVideos.value_or(MirroredVideos());
  if (mirrored.cause != MirroredVideos::Cause::None) {
    mirrored_ = mirrored;
    proposal_ = best;
    Q_EMIT mirroredVideosFound();
    return;
  }
  if (!best.isMirrored && isSameBoard(best.board, request_.board.board)) {
    Q_EMIT boardConfirmed(best.imageCount, best.searchedImageCount);
    return;
  }
  proposal_ = best;
  Q_EMIT boardProposed(false);
}

void BoardCalibrator::useProposal() {
  if (!proposal_) {
    return;
  }
  BoardGuideRequest request = request_;
  request.board.board = proposal_->board;
  proposal_.reset();
  failure_.clear();
  setGuideRequest(request);
}

void BoardCalibrator::mirrorImages() {
  const MirroredVideos mirrored = std::exchange(mirrored_, {});
  useProposal();
  const auto made = document_.edit(tr("Mirror images"), [&](Project& project) {
    project = withUnmirroredVideos(std::move(project), mirrored);
  });
  if (!made) {
    Q_EMIT failed(errorText(made.error()));
  }
}

void BoardCalibrator::cancel() {
  job_->cancel();
}

void BoardCalibrator::startGuidance() {
  outcome_.reset();
  failure_.clear();
  lastWatchedFrames_.reset();
  setWatching(true);
  watch_->start(project(), request_);
  Q_EMIT playRequested();
  Q_EMIT changed();
  Q_EMIT guideChanged();
}

void BoardCalibrator::setWatching(bool watching) {
  if (watching_ != watching) {
    watching_ = watching;
    Q_EMIT boardVisibilityChanged(watching);
  }
}

void BoardCalibrator::stopGuidance() {
  setWatching(false);
  Q_EMIT changed();
}

bool BoardCalibrator::hasCapturedViews() const {
  const auto state = guideState();
  return state->detections &&
         std::ranges::any_of(state->detections->cameras,
                             [](const auto& camera) { return !camera.views.empty(); });
}

void BoardCalibrator::calibrateFromCapturedViews() {
  if (isComputing() || !hasCapturedViews()) {
    return;
  }
  setWatching(false);
  const auto state = guideState();
  compute(
      [project = project(), seen = state->detections, goal = request_.goal,
       request = requestForCapturedViews(request_, *state)](const CalibrationProgress& progress) {
        return BoardRecordingCalibration{
            calibrateFromBoards(project, *seen, request, goal, progress)};
      },
      false);
}

std::function<void()> BoardCalibrator::wakeUp() {
  // Called by a thread that may outlive this: it holds what it uses.
  return [this, mailbox = mailbox_.sender(), pending = std::make_shared<std::atomic<bool>>(false)] {
    if (pending->exchange(true)) {
      return;
    }
    mailbox.post([this, pending] {
      // Cleared before reading: what is published from here on earns a wake-up of its own.
      *pending = false;
      finishWhenGuided();
      Q_EMIT guideChanged();
    });
  };
}

void BoardCalibrator::finishWhenGuided() {
  if (watching_ && guideState()->phase == BoardGuideState::Phase::Finished) {
    calibrateFromCapturedViews();
  }
}

bool BoardCalibrator::isApplied() const {
  return outcome_ && outcome_->project.cameras.size() == project().cameras.size() &&
         withOutcome(project(), *outcome_).cameras == project().cameras;
}

void BoardCalibrator::apply() {
  const auto outcome = outcome_;
  if (!outcome || isApplied()) {
    return;
  }
  if (outcome->project.cameras.size() != project().cameras.size()) {
    failure_ = tr("The cameras of the project have changed: calibrate again.");
    outcome_.reset();
    Q_EMIT changed();
    return;
  }
  const auto made = document_.edit(tr("Calibrate with a board"), [&](Project& project) {
    project = withOutcome(std::move(project), *outcome);
  });
  failure_ = made ? QString() : errorText(made.error());
  Q_EMIT changed();
}

void BoardCalibrator::write(const std::function<Status()>& task, const QString& file, int sheets) {
  writer_->start(
      [this, task, file, sheets](const BackgroundJob::Progress&) -> std::function<void()> {
        const Status done = task();
        const QString sentence = done ? QString() : errorText(done.error());
        return [this, sentence, file, sheets] {
          sentence.isEmpty() ? Q_EMIT saved(file) : Q_EMIT failed(sentence);
          if (sentence.isEmpty() && sheets > 1) {
            Q_EMIT printedOnSeveralSheets(file, sheets);
          }
        };
      });
}

void BoardCalibrator::saveReport(const QString& file) {
  if (outcome_) {
    write([outcome = outcome_,
           path = file.toStdString()] { return writeTextFile(path, outcome->report); },
          file);
  }
}

void BoardCalibrator::printBoard(const QString& paper, const QString& file) {
  const auto sheets = paperNamed(paper.toStdString()).and_then([this](const Paper& sheet) {
    return countSheetsToPrint(request_.board.board, sheet);
  });
  write(
      [board = request_.board.board, name = paper.toStdString(), path = file.toStdString()] {
        return paperNamed(name).and_then([&](const Paper& sheet) {
          return dewpoint::calibration::printBoard(board, sheet, path);
        });
      },
      file, sheets.value_or(1));
}

void BoardCalibrator::discardResults() {
  outdated_ = isComputing();
  job_->cancel();
  setWatching(false);
  outcome_.reset();
  failure_.clear();
  proposal_.reset();
  mirrored_ = {};
  request_.board.floorFrame.reset();
  Q_EMIT guideRequestChanged();
  Q_EMIT changed();
}

} // namespace dewpoint::ui

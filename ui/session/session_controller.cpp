// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session_controller.h"

#include "core/project/project.h"
#include "core/session/run/tracking_run.h"
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/document/document.h"
#include "ui/preferences/preferences.h"
#include "ui/selection/selection.h"
#include "ui/session/background_image_loader.h"
#include "ui/session/logged_records.h"
#include "ui/session/open_request.h"
#include "ui/session/result_refresher.h"
#include "ui/session/session_bridge.h"

#include <QRandomGenerator>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

SessionController::SessionController(ProjectOpener opener, Document& document, Selection& selection,
                                     QObject* parent)
    : QObject(parent), loader_(new ProjectLoader(std::move(opener), this)),
      backgroundImageLoader_(new BackgroundImageLoader(this)), results_(new ResultRefresher(this)),
      document_(document), selection_(selection) {
  connect(loader_, &ProjectLoader::opened, this, &SessionController::applyOpened);
  connect(loader_, &ProjectLoader::failed, this,
          [this](const OpenRequest& request, const QString& sentence, const MissingFiles& missing) {
            Q_EMIT openFailed(sentence);
            if (missing && !request.keepsHistory) {
              Q_EMIT filesMissing(request, missing);
            }
          });
  connect(loader_, &ProjectLoader::openingChanged, this, &SessionController::openingChanged);
  connect(backgroundImageLoader_, &BackgroundImageLoader::failed, this, &SessionController::failed);
  connect(backgroundImageLoader_, &BackgroundImageLoader::loaded, this,
          [this](const auto& files, const auto& images) {
            if (bridge_ != nullptr) {
              bridge_->session().setBackgroundImages(files, images);
              results_->onSettingEdited();
            }
          });
  connect(results_, &ResultRefresher::refreshed, this, [this] {
    if (const auto wanted = std::exchange(showWhenRefreshed_, std::nullopt)) {
      showFrame(*wanted);
    }
    if (std::exchange(playWhenRefreshed_, false)) {
      play();
    }
  });
  connect(&selection_, &Selection::frameRequested, this,
          [this](qint64 frame) { showFrame(std::optional(frame)); });
  connect(&selection_, &Selection::liveFrameRequested, this, [this] { showFrame(std::nullopt); });
  connectDocument();
}

SessionController::~SessionController() {
  if (bridge_ != nullptr) {
    disconnect(bridge_, nullptr, this, nullptr);
  }
}

bool SessionController::followsDocument() const {
  return bridge_ != nullptr && document_.project().cameras.size() == cameraCount_;
}

void SessionController::connectDocument() {
  connect(&document_, &Document::parameterChanged, this, [this] {
    if (followsDocument()) {
      bridge_->session().setParameters(document_.project().parameters);
      results_->onSettingEdited();
    }
  });
  connect(&document_, &Document::methodChanged, this, &SessionController::applyMethod);
  connect(&document_, &Document::targetsChanged, this, [this] {
    if (followsDocument()) {
      bridge_->session().setTargets(document_.project().targets);
      results_->onSettingEdited();
    }
  });
  connect(&document_, &Document::volumeChanged, this, [this] {
    if (followsDocument()) {
      bridge_->session().setVolumeOfInterest(document_.project().volumeOfInterest);
      results_->onSettingEdited();
    }
  });
  connect(&document_, &Document::personCorrectionsChanged, this, [this] {
    if (followsDocument()) {
      bridge_->session().setPersonCorrections(document_.project().personCorrections);
    }
  });
  connect(&document_, &Document::correctionsChanged, this, [this] {
    if (followsDocument()) {
      bridge_->session().setCorrections(document_.project().corrections);
    }
  });
  // Queued: what is being edited may be a view that goes with it.
  connect(&document_, &Document::calibrationChanged, this, &SessionController::applyCalibration,
          Qt::QueuedConnection);
  connect(&document_, &Document::backgroundImagesChanged, this, [this] {
    if (followsDocument()) {
      backgroundImageLoader_->load(document_.project());
    }
  });
  connect(&document_, &Document::sourcesChanged, this, &SessionController::reopen,
          Qt::QueuedConnection);
}

Session* SessionController::session() const {
  return bridge_ != nullptr ? &bridge_->session() : nullptr;
}

void SessionController::open(OpenRequest request) {
  loader_->open(std::move(request));
}

void SessionController::reopen() {
  // A project that is being opened takes the place of this one anyway.
  if (bridge_ != nullptr && (!loader_->isOpening() || loader_->isReopening())) {
    loader_->open({.sessionRequest = document_.project(), .keepsHistory = true});
  }
}

void SessionController::applyOpened(const OpenRequest& request,
                                    const std::shared_ptr<SessionInputs>& inputs) {
  endRun();
  Q_EMIT documentAboutToBeReplaced(request);
  if (!request.keepsHistory) {
    document_.replaceProject(inputs->project, request.isUnsaved);
  } else if (inputs->source->isLive()) {
    storeImageSizes(inputs->project);
  }
  Q_EMIT documentReplaced(request);
  // The panels have just been filled; the views come with the next turn of the event loop, so that
  // neither holds it for long.
  QTimer::singleShot(0, this, [this, request, inputs, number = ++starts_] {
    if (number == starts_) {
      start(request, std::move(*inputs));
    }
  });
}

void SessionController::storeImageSizes(const Project& opened) {
  const auto change = [&](Project& project) {
    for (std::size_t k = 0; k < project.cameras.size() && k < opened.cameras.size(); ++k) {
      project.cameras[k].camera.intrinsics = opened.cameras[k].camera.intrinsics;
      project.cameras[k].camera.cameraFromWorld = opened.cameras[k].camera.cameraFromWorld;
    }
  };
  // Only what is guessed of live cameras differs: they are of the size that they send.
  static_cast<void>(document_.completeSources(tr("Use image size of the cameras"), change));
}

void SessionController::start(const OpenRequest& request, SessionInputs inputs) {
  // Without a target a recording waits for the click instead of running away; live cameras are
  // seen at once. It does not wait for the box of a target that the project already has.
  const std::vector<Target>& targets = inputs.project.targets;
  const bool wantsTarget =
      targets.empty() && methodFamily(inputs.project.method).lacksTargets(targets);
  const bool waits = !inputs.source->isLive() && (request.isUnsaved || wantsTarget);
  inputs.threadCount = Preferences().filterThreadCount();
  feeds_ = std::exchange(inputs.feeds, {});
  cameraCount_ = inputs.project.cameras.size();
  // Of the window, not of this: it goes after the views, which look at the session to the end.
  bridge_ = new SessionBridge(std::move(inputs), parent());
  results_->watchSession(&bridge_->session());
  connect(bridge_, &SessionBridge::snapshotChanged, this, &SessionController::publish);
  bridge_->session().setPace(pace_);
  Q_EMIT runStarted();
  publish(bridge_->session().newest());
  if (playOnOpen_ && !waits) {
    bridge_->session().play();
  } else {
    bridge_->session().stepFrame(); // something to look at
  }
  Q_EMIT opened(request);
}

void SessionController::close() {
  ++starts_;
  endRun();
  document_.replaceProject({});
  Q_EMIT closed();
}

void SessionController::endRun() {
  if (bridge_ != nullptr) {
    Q_EMIT runAboutToEnd();
  }
  SessionBridge* over = std::exchange(bridge_, nullptr);
  backgroundImageLoader_->cancel();
  results_->watchSession(nullptr);
  discardRequests();
  shown_.reset();
  filledFrom_.reset();
  filled_.reset();
  frames_ = {};
  iterations_ = {};
  feeds_.clear();
  Q_EMIT runEnded(); // first: what is cleared may look at the run
  Q_EMIT snapshotChanged(nullptr);
  selection_.clear();
  if (over != nullptr) {
    ProjectLoader::destroyInBackground(over->release());
    delete over;
  }
}

TrackSnapshotPtr SessionController::withMissingImagesFilled(const TrackSnapshotPtr& snapshot) {
  if (bridge_ == nullptr || snapshot == nullptr) {
    return snapshot;
  }
  if (snapshot != filledFrom_) {
    filledFrom_ = snapshot;
    filled_ = bridge_->withMissingImagesFilled(snapshot);
  }
  return filled_;
}

void SessionController::publish(const TrackSnapshotPtr& snapshot) {
  shown_ = snapshot;
  const Session& session = bridge_->session();
  const LoggedFrames frames{session.framesSince(frames_.generation, frames_.position)};
  Q_EMIT framesLogged(frames);
  Q_EMIT snapshotChanged(snapshot);
  results_->processSnapshot(*snapshot, frames.restarted);
  Q_EMIT iterationsLogged({session.iterationsSince(iterations_.generation, iterations_.position)});
}

void SessionController::applyMethod() {
  if (!followsDocument()) {
    return;
  }
  results_->suspend();
  const Project& project = document_.project();
  Session& session = bridge_->session();
  // What was tracked of a recording is tracked again: how long the other method takes is not known
  // before. Of live cameras whoever looks at an earlier frame wants to see it from there.
  const bool isRecorded = shown_ && shown_->frameCount;
  if (selection_.isAwayFromLiveFrame() || (isRecorded && shown_->history.newestTrackedFrame >= 0)) {
    session.setMethodFrom(isRecorded ? 0 : selection_.currentFrame(), project.method,
                          project.parameters);
  } else {
    session.setMethod(project.method, project.parameters);
  }
}

void SessionController::applyCalibration() {
  if (!followsDocument()) {
    return;
  }
  const CameraRig rig = rigOf(document_.project());
  const auto newest = bridge_->session().newest();
  if (newest->rig && haveSameImageSizes(rig, *newest->rig)) {
    bridge_->session().setCameras(rig); // the run goes on
    results_->onSettingEdited();
  } else {
    reopen();
  }
}

bool SessionController::isPlaying() const {
  return shown_ && shown_->state == PlayState::Playing;
}

void SessionController::play() {
  if (bridge_ == nullptr) {
    return;
  }
  if (results_->isRefreshing()) {
    playWhenRefreshed_ = true; // the frames that are tracked again lead to where it goes on
    return;
  }
  results_->suspend();
  bridge_->session().play();
}

void SessionController::showFrame(std::optional<qint64> frame) {
  if (bridge_ == nullptr) {
    return;
  }
  if (results_->isRefreshing()) {
    showWhenRefreshed_ = frame; // to show it now would end the tracking
  } else if (frame) {
    bridge_->session().showFrame(*frame);
  } else {
    bridge_->session().returnToNewestFrame();
  }
}

void SessionController::discardRequests() {
  results_->suspend();
  playWhenRefreshed_ = false;
  showWhenRefreshed_.reset();
}

void SessionController::setPace(const Pace& pace) {
  if (pace == pace_) {
    return;
  }
  pace_ = pace;
  if (bridge_ != nullptr) {
    bridge_->session().setPace(pace_);
  }
  Q_EMIT paceChanged(pace_);
}

void SessionController::togglePlay() {
  if (bridge_ == nullptr) {
    return;
  }
  Session& session = bridge_->session();
  const PlayState state = shown_ ? shown_->state : PlayState::Paused;
  if (state == PlayState::Playing) {
    playWhenRefreshed_ = false;
    session.pause();
    return;
  }
  if (state == PlayState::Ended) {
    Q_EMIT runAboutToRestart();
    discardRequests();
    session.restart();
  }
  play();
}

void SessionController::restart(bool newSeed) {
  if (bridge_ == nullptr) {
    return;
  }
  Q_EMIT runAboutToRestart();
  discardRequests();
  if (newSeed) {
    // 31 bits: short enough to be read out and typed.
    bridge_->session().restart(QRandomGenerator::global()->generate() >> 1U);
  } else {
    bridge_->session().restart();
  }
}

void SessionController::applyFilterThreadCount() {
  if (bridge_ != nullptr) {
    bridge_->session().setFilterThreadCount(Preferences().filterThreadCount());
  }
}

void SessionController::rerun() {
  if (bridge_ != nullptr && selection_.currentFrame() >= 0) {
    results_->suspend();
    bridge_->session().rerunFrom(selection_.currentFrame());
  }
}

void SessionController::startAfterLearning(bool isNewTarget) {
  const bool isTracked = shown_ && shown_->frameCount && shown_->history.newestTrackedFrame > 0;
  if (!shown_ || isPlaying() || !isNewTarget || isTracked) {
    return;
  }
  const bool isLate = shown_->frameCount && shown_->frame > 0 && shown_->state != PlayState::Ended;
  togglePlay(); // at the end: from the beginning
  if (isLate) {
    Q_EMIT startedAtLaterFrame(shown_->frame);
  }
}

void SessionController::startAfterBoxDrawn(bool isFirstBox) {
  if (!shown_ || shown_->state != PlayState::Paused || !isFirstBox) {
    return;
  }
  // From a frame that was tracked already it is tracked again by itself, up to where the run
  // stands; at the end there is nothing to play.
  const bool again = shown_->isPast && shown_->frame <= shown_->history.newestTrackedFrame;
  const auto hasBox = [](const Target& one) { return one.box.has_value(); };
  const bool only = std::ranges::count_if(document_.project().targets, hasBox) == 1 &&
                    shown_->history.newestTrackedFrame <= 0;
  if (only && !again) {
    play();
  }
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/tracking_loop.h"

#include "core/base/thread_priority.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace dewpoint::session {
namespace {

constexpr std::chrono::milliseconds kSnapshotInterval(30);
/// How often a paused live run looks whether its cameras have other problems: a silent camera is to
/// be seen within a second (LiveCameraThread).
constexpr std::chrono::milliseconds kNoticeInterval(150);
/// How long a rerun may keep the view; one that takes longer shows where it is.
constexpr std::chrono::seconds kLongestKeptView(2);

} // namespace

TrackingLoop::TrackingLoop(SessionInputs inputs)
    : builder_(TruthTable(inputs.truth)), driver_(std::move(inputs), tap_, log_, builder_.truth()) {
}

void TrackingLoop::run(const std::stop_token& stop) {
  setThreadPriority(ThreadPriority::Prompt);
  driver_.start();
  publish(Publish::Now);
  while (!stop.stop_requested()) {
    if (const auto command = commands_.pop(stop, deadline())) {
      execute(*command);
      continue;
    }
    if (playback().missingContent() == Playback::MissingContent::Images) {
      publish(Publish::Now);
      continue;
    }
    if (playback().missingContent() == Playback::MissingContent::Maps) {
      addMaps(stop);
    }
    if (stop.stop_requested()) {
      break;
    }
    if (playback().isRunning()) {
      takeDueStep();
    } else if (driver_.haveNoticesChanged()) {
      publish(Publish::Now);
    }
  }
}

std::optional<TrackingLoop::Clock::time_point> TrackingLoop::deadline() const {
  const bool isIncomplete = playback().missingContent() != Playback::MissingContent::Nothing;
  if (isIncomplete || (playback().isRunning() && playback().rerunRange())) {
    return Clock::now();
  }
  if (playback().isRunning()) {
    return nextStepDue_;
  }
  const bool mayChange = driver_.isReady() && driver_.isLive();
  return mayChange ? std::optional(Clock::now() + kNoticeInterval) : std::nullopt;
}

PlaybackPace::Situation TrackingLoop::situation() const {
  const bool isReplaying = playback().viewedFrame().has_value();
  return {.framesPerSecond = driver_.framesPerSecond(),
          .isAtFullSpeed = playback().rerunRange() || (driver_.isLive() && !isReplaying),
          .isReplaying = isReplaying,
          .iterationCount = driver_.iterationCount(),
          .isEveryTargetHeld = driver_.isEveryTargetHeld()};
}

void TrackingLoop::scheduleFirstStep() {
  const PlaybackPace::Step step = pace_.nextStep(situation());
  nextStepDue_ = Clock::now();
  if (step.isIteration) { // first it is seen what is known before it
    nextStepDue_ += std::chrono::duration_cast<Clock::duration>(step.period);
  }
}

void TrackingLoop::takeDueStep() {
  const auto begin = Clock::now();
  driver_.advance(pace_.nextStep(situation()).isIteration);
  publish(playbackPublish());
  const PlaybackPace::Situation now = situation();
  const auto period = std::chrono::duration_cast<Clock::duration>(pace_.nextStep(now).period);
  nextStepDue_ = now.isAtFullSpeed ? begin : std::max(nextStepDue_ + period, begin);
}

TrackingLoop::Publish TrackingLoop::playbackPublish() const {
  const bool isFast = playback().isRunning() && pace_.pace().speedFactor > 1.0 && !driver_.isLive();
  return playback().rerunRange() || isFast ? Publish::Throttled : Publish::Now;
}

void TrackingLoop::publish(Publish how) {
  if (how == Publish::Not) {
    return;
  }
  const auto now = Clock::now();
  const bool isViewKept = playback().rerunRange() && now < viewKeptUntil_;
  if (isViewKept || (how == Publish::Throttled && now - published_ < kSnapshotInterval)) {
    return;
  }
  auto snapshot = std::make_shared<TrackSnapshot>();
  driver_.fillSnapshot(builder_, how == Publish::Quickly, *snapshot);
  published_ = Clock::now();
  publisher_.publish(std::move(snapshot));
}

void TrackingLoop::addMaps(const std::stop_token& stop) {
  auto snapshot = std::make_shared<TrackSnapshot>(*publisher_.newestSnapshot());
  const auto shouldContinue = [&] { return !stop.stop_requested() && commands_.empty(); };
  driver_.addMaps(builder_, *snapshot, shouldContinue);
  publisher_.publish(std::move(snapshot));
}

void TrackingLoop::execute(const Command& command) {
  if (driver_.isReady()) {
    publish(std::visit([this](const auto& request) { return handle(request); }, command));
  } else if (const auto* request = std::get_if<command::DescribeFrame>(&command)) {
    request->receive(failure(ErrorCode::NotFound, "", "", "there are no frames"));
  }
}

TrackingLoop::Publish TrackingLoop::handle(const command::Play&) {
  driver_.play();
  scheduleFirstStep();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Pause&) {
  driver_.pause();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::StepFrame&) {
  driver_.stepFrame();
  return playbackPublish();
}

TrackingLoop::Publish TrackingLoop::handle(const command::StepIteration&) {
  driver_.stepIteration();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Restart& request) {
  driver_.restart(request.seed);
  scheduleFirstStep();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetParameters& request) {
  RunDefinition wanted = driver_.definition();
  wanted.parameters = request.parameters;
  driver_.change(std::move(wanted));
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetMethod& request) {
  driver_.setMethod(request);
  scheduleFirstStep();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetTargets& request) {
  driver_.setTargets(request.targets);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetCameras& request) {
  driver_.setCameras(request.rig);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetBackgroundImages& request) {
  driver_.setBackgroundImages(request);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetPersonCorrections& request) {
  driver_.setPersonCorrections(request.corrections);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetVolumeOfInterest& request) {
  RunDefinition wanted = driver_.definition();
  wanted.volumeOfInterest = request.volume;
  driver_.change(std::move(wanted));
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetCorrections& request) {
  driver_.setCorrections(request.corrections);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetThreadCount& request) {
  driver_.setThreadCount(request.threadCount);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetPace& request) {
  pace_.setPace(request.pace);
  scheduleFirstStep();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowMasks& request) {
  builder_.options().includesMasks = request.isShown;
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowMaps& request) {
  builder_.options().includesMaps = request.isShown;
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowBodyShapes& request) {
  builder_.options().includesBodyShapes = request.isShown;
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowCalibrationBoard& request) {
  driver_.setCalibrationBoardShown(request.isShown);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowFrame& request) {
  driver_.show(request.frame);
  return Publish::Quickly;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ReturnToNewestFrame&) {
  driver_.returnToNewestFrame();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Rerun& request) {
  driver_.rerun(request.fromFrame, request.keepView);
  viewKeptUntil_ = Clock::now();
  if (request.keepView) {
    viewKeptUntil_ += kLongestKeptView;
  }
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::DescribeFrame& request) {
  auto snapshot = std::make_shared<TrackSnapshot>();
  const Status described = driver_.describe(builder_, request.frame, request.isWanted, *snapshot);
  if (described) {
    request.receive(std::shared_ptr<const TrackSnapshot>(std::move(snapshot)));
  } else {
    request.receive(tl::make_unexpected(described.error()));
  }
  return Publish::Not;
}

} // namespace dewpoint::session

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run_driver.h"

#include "core/base/thread_count.h"
#include "core/session/box_counterparts.h"
#include "core/session/people/person_correction.h"
#include "core/session/rerun_range.h"
#include "core/session/rewind/correction_changes.h"
#include "core/tracking/catalog/method_catalog.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace dewpoint::session {

RunDriver::RunDriver(SessionInputs inputs, FrameTapSlot& tap, RunLog& log, const TruthTable& truth)
    : project_(std::move(inputs.project)), input_(std::move(inputs.source)), tap_(tap), log_(log),
      current_(RunDefinition::fromProject(project_, inputs.backgroundImages),
               threadCountForFilter(inputs.threadCount)),
      watches_(*definition().rig), recorder_(log, truth) {
  replaceRun(definition(), 0);
  if (input_.hasSource()) {
    current_.keepHistory(input_.source(), inputs.maxHistoryBytes);
  }
  log_.restart(project(), current_.threadCount());
}

bool RunDriver::replaceRun(RunDefinition definition, std::int64_t iterations) {
  const auto replaced = current_.startNewRun(std::move(definition), iterations);
  if (!replaced) {
    note(replaced.error());
  }
  return replaced.has_value();
}

void RunDriver::start() {
  if (isReady()) {
    takeFrame();
  }
}

Result<FrameSetPtr> RunDriver::nextFrames() {
  recorder_.noteWorkBegin();
  // What a live run goes over again is in the library; when it is through, the cameras go on.
  if (takesFromCameras()) {
    return input_.next();
  }
  const std::int64_t next = playback_.nextFrame();
  const auto frame = timeTravel().nearestFrame(next);
  return frame && *frame >= next ? timeTravel().framesAt(*frame)
                                 : Result<FrameSetPtr>(FrameSetPtr());
}

bool RunDriver::takeFrame() {
  auto taken = nextFrames();
  if (!taken) {
    note(taken.error());
  }
  if (!taken || !*taken) {
    playback_.endInput();
    return false;
  }
  noteTaken(**taken);
  if (!hasImages(**taken)) {
    return false; // live, and nothing came
  }
  if (!playback_.rerunRange()) {
    tap_.deliver(*taken);
  }
  current_.beginFrame(*taken);
  playback_.setHead((*taken)->index);
  recorder_.noteFrameTaken(takesFromCameras());
  return true;
}

void RunDriver::iterateFrame(FrameStep step) {
  // The frame shown first was already taken, but has had no iteration yet.
  const bool hasWaited = playback_.headProgress() == Playback::HeadProgress::Taken;
  if (hasWaited) {
    recorder_.resetArrivalTime();
  }
  if (hasWaited || playback_.headProgress() == Playback::HeadProgress::Tracked || takeFrame()) {
    const auto isDone = trackFrame(run(), observers_, step);
    if (!isDone) {
      note(isDone.error());
    }
    playback_.noteIteration(); // also without any target
    std::ranges::move(run().takeCorrectionErrors(), std::back_inserter(errors_));
    if (isDone.value_or(true)) {
      record();
    }
  }
  if (const auto again = playback_.noteFrameReached(headFrame())) {
    show(*again);
  }
}

void RunDriver::advance(bool oneIteration) {
  if (playback_.viewedFrame()) {
    showNext();
  } else {
    iterateFrame(oneIteration ? FrameStep::OneIteration : FrameStep::WholeFrame);
  }
}

void RunDriver::play() {
  const auto viewed = playback_.viewedFrame();
  const bool isEnded = std::holds_alternative<Playback::Ended>(playback_.state());
  if (viewed && *viewed > headFrame()) {
    rerun(*viewed); // from a part that was not tracked yet
  } else if (!isEnded || restart(std::nullopt)) {
    playback_.play();
  }
  recorder_.noteInterruption();
}

void RunDriver::stepFrame() {
  playback_.hold();
  if (!std::holds_alternative<Playback::Ended>(playback_.state())) {
    advance();
  }
}

void RunDriver::stepIteration() {
  playback_.returnToNewestFrame();
  playback_.hold();
  if (!run().frames() && !takeFrame()) {
    return;
  }
  recorder_.onIteration(run(), run().iterateTimed());
  playback_.noteIteration();
  record();
}

bool RunDriver::restart(std::optional<std::uint64_t> seed) {
  errors_.clear();
  current_.restart(seed);
  log_.restart(project(), current_.threadCount());
  if (!isLive()) { // live cameras stay where they are; the calibrated place is still known
    watches_.restart();
  }
  recorder_.restart();
  playback_.restart();
  if (const auto sought = input_.restart(); !sought) {
    note(sought.error());
    playback_.endInput();
    return false;
  }
  takeFrame();
  return playback_.playState() != PlayState::Ended;
}

void RunDriver::rerun(std::int64_t from, const command::SetMethod* method, bool keepView) {
  const auto wanted = framesToRerun(current_, playback_, from, method);
  if (!wanted) {
    return;
  }
  const RerunState range = *wanted;
  from = range.firstFrame;
  const bool isPast = from <= range.lastFrame;
  errors_.clear();
  RunDefinitionPtr before = current_.definition();
  if (method != nullptr) {
    RunDefinition other = definition();
    other.method = method->method;
    other.parameters = method->parameters;
    const TrackedFrame* last = timeTravel().history().before(from);
    if (!replaceRun(std::move(other), last != nullptr ? last->totalIterationCount : 0)) {
      return;
    }
    timeTravel().removeCheckpoints();
  } else if (isPast) {
    if (const auto reached = current_.goBack(from, isLive()); !reached) {
      note(reached.error());
      playback_.endInput();
      return;
    }
    before = run().definition();
  }
  if (isPast) {
    timeTravel().forgetFrom(from);
    log_.goBack(from);
    recorder_.goBack(from);
    playback_.rerun(range, keepView ? playback_.viewedFrame() : std::nullopt);
  } else {
    playback_.continueTrackingAt(from);
  }
  if (!takeFrame()) {
    return;
  }
  current_.applyLaterChanges();
  log_.noteSettingsChange(from, differences(*before, definition()));
  log_.updateProject(project());
}

bool RunDriver::change(RunDefinition wanted) {
  const bool taken = current_.change(std::move(wanted));
  if (taken) {
    log_.updateProject(project());
  }
  return taken;
}

void RunDriver::setMethod(const command::SetMethod& request) {
  if (request.fromFrame) {
    rerun(*request.fromFrame, &request, true);
    return;
  }
  RunDefinition other = definition();
  other.method = request.method;
  other.parameters = request.parameters;
  if (replaceRun(std::move(other), 0)) {
    restart(std::nullopt);
  }
}

void RunDriver::setTargets(const std::vector<Target>& targets) {
  RunDefinition wanted = definition();
  wanted.targets = targets;
  if (run().definition()->family().retracksAfterEdit) {
    changeBoxes(std::move(wanted));
    return;
  }
  const FrameSetPtr frames = run().frames();
  if (change(wanted) || !replaceRun(std::move(wanted), run().iterationCount())) {
    return;
  }
  // Another number of targets: new beliefs, on the frame that the run stands at.
  log_.updateProject(project());
  timeTravel().removeCheckpoints();
  playback_.forgetEstimates();
  if (frames) {
    timeTravel().startTailsAt(frames->index);
    current_.beginFrame(frames);
  }
}

void RunDriver::changeBoxes(RunDefinition wanted) {
  const auto from = firstChangedFrame(definition().targets, wanted.targets);
  const std::vector<int> numbers = newIndices(definition().targets, wanted.targets);
  change(std::move(wanted));
  if (!areIndicesUnchanged(numbers)) {
    log_.changeTargetIndices(numbers, definition().targets.size());
  }
  const auto viewed = playback_.viewedFrame();
  if ((!from && run().frames()) || from == headFrame()) { // a target may begin in the image shown
    playback_.headProgress() == Playback::HeadProgress::Taken ? iterateFrame() : record();
  } else if (from && *from < headFrame()) {
    rerun(*from);
  } else if (from && viewed == from) { // in a part that was not tracked yet
    rerun(*from);
    playback_.pause();
    if (playback_.headProgress() == Playback::HeadProgress::Taken) {
      iterateFrame();
    }
  }
}

void RunDriver::setCameras(const CameraRig& rig) {
  RunDefinition wanted = definition();
  wanted.rig = std::make_shared<const CameraRig>(rig);
  if (change(std::move(wanted))) {
    watches_.setCameras(rig);
  }
}

void RunDriver::setBackgroundImages(const command::SetBackgroundImages& request) {
  if (request.images.size() != definition().rig->size()) {
    return;
  }
  RunDefinition wanted = definition();
  std::copy_n(request.files.begin(),
              std::min(request.files.size(), wanted.backgroundImageFiles.size()),
              wanted.backgroundImageFiles.begin());
  wanted.backgroundImages = request.images;
  change(std::move(wanted));
}

template <class Correction>
std::vector<Correction>
RunDriver::replaceCorrections(std::vector<Correction> RunDefinition::*member,
                              const std::vector<Correction>& wanted, bool canApply) {
  const auto from = firstDifferingFrame(definition().*member, wanted);
  auto added = appendedCorrections(definition().*member, wanted);
  RunDefinition other = definition();
  other.*member = wanted;
  change(std::move(other));
  if (!from || *from > headFrame() || !canApply) {
    return {};
  }
  if (*from < headFrame() || !added ||
      playback_.headProgress() != Playback::HeadProgress::Recorded) {
    rerun(*from, true);
    return {};
  }
  std::erase_if(*added, [this](const Correction& one) { return one.frame != headFrame(); });
  return std::move(*added);
}

void RunDriver::setPersonCorrections(const std::vector<PersonCorrection>& people) {
  const auto ofHead = replaceCorrections(&RunDefinition::personCorrections, people,
                                         run().supportsCorrections<PersonEditing>());
  for (const PersonCorrection& correction : ofHead) { // the head needs no tracking again
    current_.change(run().effectOf(correction));
  }
  if (!ofHead.empty()) {
    std::ranges::move(run().takeCorrectionErrors(), std::back_inserter(errors_));
    record();
  }
}

void RunDriver::setCorrections(const std::vector<PositionCorrection>& corrections) {
  const auto ofHead = replaceCorrections(&RunDefinition::corrections, corrections,
                                         run().supportsCorrections<PositionCorrecting>());
  for (const PositionCorrection& correction : ofHead) {
    current_.change(correction);
  }
  if (!ofHead.empty()) {
    record();
  }
}

void RunDriver::setThreadCount(int wanted) {
  const int threads = threadCountForFilter(wanted);
  if (threads != current_.threadCount()) {
    current_.setThreadCount(threads);
    log_.setThreadCount(threads);
  }
}

void RunDriver::showFrame(const SnapshotBuilder& builder, bool quickly, TrackSnapshot& snapshot) {
  if (const auto viewed = playback_.viewedFrame()) {
    snapshot.isPast = true;
    const auto shown = builder.fillFromPastFrame(run(), timeTravel(), *viewed, quickly, snapshot);
    if (shown) {
      return;
    }
    note(shown.error());
    playback_.returnToNewestFrame();
    snapshot.isPast = false;
  }
  const bool isRecorded = playback_.headProgress() == Playback::HeadProgress::Recorded;
  builder.fillFromCurrentFrame(run(), current_.history(), isRecorded, snapshot);
}

void RunDriver::fillSnapshot(const SnapshotBuilder& builder, bool quickly,
                             TrackSnapshot& snapshot) {
  SnapshotBuilder::fillFromDefinition(definition(), snapshot);
  if (current_.hasRun()) {
    showFrame(builder, quickly, snapshot);
  }
  playback_.notePublished(snapshot.isPreview,
                          current_.hasRun() && builder.lacksMaps(run(), snapshot));
  snapshot.state = playback_.playState();
  snapshot.rerun = playback_.rerunRange();
  snapshot.notices = errors_;
  snapshot.cameraMotions = watches_.motionWatch().reports();
  snapshot.disagreements = watches_.agreementWatch().disagreements(snapshot.family);
  if (input_.hasSource()) {
    input_.fillSourceFields(snapshot);
    snapshot.history = timeTravel().state();
  }
  log_.setNotices(snapshot.notices,
                  input_.latestFrameTime()); // without those below, whose numbers change
  std::ranges::move(watches_.motionWatch().notices(), std::back_inserter(snapshot.notices));
  recorder_.addStatistics(snapshot);
  recorder_.updateOldResults(definition());
  log_.setFinished(playback_.hasInputEnded());
}

void RunDriver::addMaps(const SnapshotBuilder& builder, TrackSnapshot& snapshot,
                        const TimeTravel::ShouldContinue& shouldContinue) {
  playback_.noteMissingContentPublished();
  if (const TrackingRun* then = timeTravel().runAt(snapshot.frame, run(), shouldContinue)) {
    builder.addMaps(*then, snapshot);
  }
}

} // namespace dewpoint::session

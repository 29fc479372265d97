// SPDX-License-Identifier: GPL-3.0-or-later
// Taking frames and tracking them. Commands: tracking_loop_commands.cpp, snapshots:
// tracking_loop_publish.cpp.
#include "core/session/tracking_loop.h"

#include "core/base/thread_precedence.h"

#include <algorithm>

namespace dewpoint::session {
namespace {

constexpr std::size_t kTailLength = 256;
constexpr std::size_t kTimesKept = 101; // odd: the median is one of them
constexpr std::size_t kFrameTimesKept = 31;
constexpr std::size_t kRecordedHistory = std::size_t{512} << 20; // bytes
constexpr std::size_t kLiveHistory = std::size_t{1024} << 20;

template <class T> void keepNewest(std::deque<T>& values, std::size_t most) {
  while (values.size() > most) {
    values.pop_front();
  }
}

} // namespace

TrackingLoop::TrackingLoop(SessionInputs inputs)
    : project_(std::move(inputs.project)), source_(std::move(inputs.source)), truth_(inputs.truth),
      emptyRooms_(std::move(inputs.emptyRooms)),
      rig_(std::make_shared<const CameraRig>(rigOf(project_))), bumps_(*rig_) {
  auto run = TrackingRun::create(project_, 1, emptyRooms_);
  if (run) {
    run_.emplace(std::move(*run));
  } else {
    errors_.push_back(run.error());
  }
  if (source_) {
    const std::size_t usual = source_->isLive() ? kLiveHistory : kRecordedHistory;
    travel_.emplace(*source_, inputs.historyBytes > 0 ? inputs.historyBytes : usual);
  }
  log_.restart(project_);
}

void TrackingLoop::run(const std::stop_token& stop) {
  setPrecedence(Precedence::Prompt);
  if (source_ && run_) {
    takeFrame(); // shown, but not yet tracked
  }
  publish();
  while (!stop.stop_requested()) {
    const bool playing = state_ == PlayState::Playing;
    const bool more = mapsDue_ || exactDue_; // of the moment shown
    const auto due = rerun_ || more ? Clock::now() : nextFrameDue_;
    const auto deadline = playing || more ? std::optional(due) : std::nullopt;
    if (const auto command = commands_.pop(stop, deadline)) {
      obey(*command);
      continue;
    }
    if (exactDue_) {
      publish();
      continue;
    }
    if (mapsDue_) {
      addMaps(stop);
    }
    if (stop.stop_requested() || state_ != PlayState::Playing) {
      continue;
    }
    // A slow step must not be followed by a burst: the clock is moved on, frames are never skipped.
    const auto period = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(1.0 / std::max(1.0, source_->framesPerSecond())));
    const bool atOnce = rerun_ || (source_->isLive() && !view_);
    nextFrameDue_ = atOnce ? Clock::now() : std::max(nextFrameDue_ + period, Clock::now());
    if (view_) {
      showNext();
    } else {
      iterateFrame();
    }
  }
}

void TrackingLoop::reachEnd() {
  state_ = PlayState::Ended;
  atEnd_ = true;
  rerun_.reset();
}

Result<FrameSetPtr> TrackingLoop::nextFrames() {
  // What a live run goes over again is in the library; when it is through, the cameras go on.
  if (source_->isLive() && !rerun_) {
    return source_->next();
  }
  const auto frame = travel_->nearest(next_);
  return frame && *frame >= next_ ? travel_->frames(*frame) : Result<FrameSetPtr>(FrameSetPtr());
}

bool TrackingLoop::takeFrame() {
  auto taken = nextFrames();
  if (!taken) {
    errors_.push_back(taken.error());
    reachEnd();
    return false;
  }
  if (!*taken) {
    reachEnd();
    return false;
  }
  const auto& frames = (*taken)->frames;
  const auto present = [](const FramePtr& frame) { return frame != nullptr; };
  if (std::none_of(frames.begin(), frames.end(), present)) {
    return false; // live, and nothing came
  }
  if (!rerun_) {
    tap_.give(*taken);
  }
  travel_->beforeFrame(*taken, *run_);
  run_->beginFrame(*taken);
  next_ = (*taken)->index + 1;
  frameFresh_ = true;
  arrival_ = Clock::now();
  frameTimes_.push_back(arrival_);
  keepNewest(frameTimes_, kFrameTimesKept);
  return true;
}

void TrackingLoop::iterateFrame() {
  // The frame shown first was already taken, but has had no iteration yet.
  const bool waited = frameFresh_;
  if (frameFresh_ || takeFrame()) {
    arrival_ = waited ? Clock::now() : arrival_; // what a paused run waits for is not its delay
    firstArrival_ = firstArrival_.value_or(arrival_);
    for (int k = 0; k < run_->iterationsPerFrame(); ++k) {
      iterateOnce();
    }
    frameFresh_ = false; // also without any target
    if (run_->family() == MethodFamily::Targets) {
      bumps_.watch(*run_->frames(), run_->targets(), run_->estimates());
    } else if (run_->family() == MethodFamily::People) { // no targets of a known size
      bumps_.watch(*run_->frames(), {}, {});
    }
    const auto now = Clock::now();
    using Seconds = std::chrono::duration<double>;
    log_.countFrame(Seconds(now - arrival_).count(), Seconds(now - *firstArrival_).count());
    recordFrame();
  }
  if (rerun_ && head() >= rerun_->range.to) {
    finishRerun();
  }
  if (rerun_) {
    publishNowAndThen();
  } else {
    publish();
  }
}

bool TrackingLoop::iterateOnce() {
  if (!run_->frames() && !takeFrame()) {
    return false;
  }
  iterationTimes_.push_back(run_->iterate());
  log_.countIteration(1e-6 * iterationTimes_.back());
  countAgainstBudget(1e-3 * iterationTimes_.back() *
                     static_cast<double>(std::max<std::size_t>(1, run_->trackedCount())));
  keepNewest(iterationTimes_, kTimesKept);
  frameFresh_ = false;
  log_.append(iterationRecords());
  return true;
}

std::vector<IterationRecord> TrackingLoop::iterationRecords() const {
  std::vector<IterationRecord> records;
  for (std::size_t k = 0; k < run_->estimates().size(); ++k) {
    const auto& estimate = run_->estimates()[k];
    if (estimate.gone) {
      continue;
    }
    IterationRecord record;
    record.iteration = run_->iterations();
    record.frame = run_->frames()->index;
    record.target = static_cast<int>(k);
    record.spread = estimate.spread();
    record.effectiveSampleSize = estimate.effectiveSampleSize;
    record.time = seconds(run_->frames()->time);
    record.microseconds = iterationTimes_.back();
    record.spreadPerAxis = estimate.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    record.particleCount = estimate.particleCount;
    record.existence = estimate.existence;
    record.held = estimate.valid;
    record.cameras = estimate.cameras;
    const bool isPerson = run_->people() != nullptr; // which of the true ones it is, nobody knows
    if (const auto belief = run_->box(k, 0)) {
      record.similarity = belief->estimate.similarity;
      record.spread = belief->estimate.spread;
      record.particleCount = belief->estimate.particleCount;
    } else if (const auto truth = truth_.at(run_->targets()[k].name, record.frame);
               truth && !isPerson) {
      record.error = (estimate.mean - *truth).norm();
    }
    records.push_back(std::move(record));
  }
  return records;
}

void TrackingLoop::countAgainstBudget(double milliseconds) {
  const auto declared = project_.parameters.declarations();
  const bool has = std::any_of(declared.begin(), declared.end(),
                               [](const auto& one) { return one.key == "time_budget"; });
  const double budget = has ? project_.parameters.at("time_budget") : 0.0;
  if (budget != budget_.milliseconds) {
    budget_ = {budget, 0, 0};
  }
  ++budget_.iterations;
  budget_.late += milliseconds > budget ? 1 : 0;
}

void TrackingLoop::recordFrame() {
  const bool again = recordedFrame_ == run_->frames()->index;
  recordedFrame_ = run_->frames()->index;
  log_.append(run_->samples());
  log_.append(run_->boxSamples());
  const TrackedFrame& moment = travel_->record(*run_);
  log_.append(frameRecord(moment, *run_->frames()));
  if (run_->people() != nullptr && !moment.targets.empty()) {
    log_.append(peopleFrame(moment));
  }
  tails_.resize(run_->targets().size());
  for (std::size_t k = 0; run_->family() != MethodFamily::Boxes && k < tails_.size(); ++k) {
    if (again && !tails_[k].empty()) {
      tails_[k].pop_back();
    }
    if (run_->estimates()[k].gone) {
      tails_[k].clear();
      continue;
    }
    tails_[k].push_back(tailPlace(run_->estimates()[k]));
    keepNewest(tails_[k], kTailLength);
  }
}

} // namespace dewpoint::session

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/tracking_loop.h"

#include "core/color/match_image.h"

#include <algorithm>

namespace dewpoint {
namespace {

constexpr int kParticlesShown = 10000;
constexpr std::size_t kTailLength = 256;
constexpr std::size_t kTimesKept = 101; // odd: the median is one of them
constexpr std::size_t kFrameTimesKept = 31;

template <class T> void keepNewest(std::deque<T>& values, std::size_t most) {
  while (values.size() > most) {
    values.pop_front();
  }
}

double median(std::deque<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

TrackingLoop::TrackingLoop(SessionInputs inputs)
    : project_(std::move(inputs.project)), source_(std::move(inputs.source)), truth_(inputs.truth),
      rig_(std::make_shared<const CameraRig>(rigOf(project_))) {
  auto run = TrackingRun::create(project_, 1);
  if (run) {
    run_.emplace(std::move(*run));
  } else {
    errors_.push_back(run.error());
  }
  tails_.resize(project_.targets.size());
  log_.restart(project_);
}

void TrackingLoop::run(const std::stop_token& stop) {
  if (source_ && run_) {
    takeFrame(); // shown, but not yet tracked
  }
  publish();
  while (!stop.stop_requested()) {
    const bool playing = state_ == PlayState::Playing;
    const auto deadline = playing ? std::optional(nextFrameDue_) : std::nullopt;
    if (const auto command = commands_.pop(stop, deadline)) {
      obey(*command);
      continue;
    }
    if (stop.stop_requested() || state_ != PlayState::Playing) {
      continue;
    }
    // A slow step must not be followed by a burst: the clock is moved on, frames are never skipped.
    const auto period = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(1.0 / std::max(1.0, source_->framesPerSecond())));
    nextFrameDue_ =
        source_->isLive() ? Clock::now() : std::max(nextFrameDue_ + period, Clock::now());
    iterateFrame();
  }
}

void TrackingLoop::obey(const Command& command) {
  if (!run_ || !source_) {
    return;
  }
  if (std::holds_alternative<command::Play>(command)) {
    if (state_ != PlayState::Ended || restart(std::nullopt)) {
      state_ = PlayState::Playing;
    }
    nextFrameDue_ = Clock::now();
    frameTimes_.clear();
  } else if (std::holds_alternative<command::Pause>(command)) {
    state_ = state_ == PlayState::Ended ? state_ : PlayState::Paused;
  } else if (std::holds_alternative<command::StepFrame>(command)) {
    if (state_ != PlayState::Ended) {
      state_ = PlayState::Paused;
      iterateFrame();
      return;
    }
  } else if (std::holds_alternative<command::StepIteration>(command)) {
    state_ = state_ == PlayState::Ended ? state_ : PlayState::Paused;
    if (iterateOnce()) {
      recordFrame();
    }
  } else if (const auto* wish = std::get_if<command::Restart>(&command)) {
    restart(wish->seed);
  } else if (const auto* configure = std::get_if<command::Configure>(&command)) {
    project_.parameters = configure->parameters;
    run_->configure(configure->parameters);
    log_.change(project_);
  } else if (const auto* method = std::get_if<command::SetMethod>(&command)) {
    changeMethod(*method);
  } else if (const auto* targets = std::get_if<command::SetTargets>(&command)) {
    changeTargets(targets->targets);
  } else if (const auto* masks = std::get_if<command::ShowMasks>(&command)) {
    masksWanted_ = masks->wanted;
  }
  publish();
}

void TrackingLoop::changeMethod(const command::SetMethod& wish) {
  Project changed = project_;
  changed.method = wish.method;
  changed.parameters = wish.parameters;
  changed.targets = run_->targets();
  auto run = TrackingRun::create(changed, 1);
  if (!run) {
    errors_.push_back(run.error());
    return;
  }
  project_ = std::move(changed);
  run_.emplace(std::move(*run));
  restart(std::nullopt);
}

void TrackingLoop::changeTargets(const std::vector<Target>& targets) {
  project_.targets = targets;
  if (targets.size() == run_->targets().size()) {
    run_->setTargets(targets);
    return;
  }
  // Another number of targets: new beliefs, on the frame that is shown.
  auto run = TrackingRun::create(project_, 1);
  if (!run) {
    errors_.push_back(run.error());
    return;
  }
  const FrameSetPtr frames = run_->frames();
  run_.emplace(std::move(*run));
  tails_.assign(targets.size(), {});
  if (frames) {
    run_->beginFrame(frames);
    frameFresh_ = true;
  }
}

bool TrackingLoop::restart(std::optional<std::uint64_t> seed) {
  project_.seed = seed.value_or(project_.seed);
  errors_.clear();
  run_->restart(project_.seed);
  log_.restart(project_);
  firstArrival_.reset();
  for (auto& tail : tails_) {
    tail.clear();
  }
  iterationTimes_.clear();
  frameTimes_.clear();
  frameFresh_ = false;
  recordedFrame_.reset();
  if (const auto sought = source_->seek(0); !sought) {
    errors_.push_back(sought.error());
    state_ = PlayState::Ended;
    return false;
  }
  if (state_ == PlayState::Ended) {
    state_ = PlayState::Paused;
  }
  takeFrame();
  nextFrameDue_ = Clock::now();
  return state_ != PlayState::Ended;
}

bool TrackingLoop::takeFrame() {
  auto taken = source_->next();
  if (!taken) {
    errors_.push_back(taken.error());
    state_ = PlayState::Ended;
    return false;
  }
  if (!*taken) {
    state_ = PlayState::Ended;
    return false;
  }
  const auto& frames = (*taken)->frames;
  const auto present = [](const FramePtr& frame) { return frame != nullptr; };
  if (std::none_of(frames.begin(), frames.end(), present)) {
    return false; // live, and nothing came
  }
  run_->beginFrame(*taken);
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
    const auto now = Clock::now();
    using Seconds = std::chrono::duration<double>;
    log_.countFrame(Seconds(now - arrival_).count(), Seconds(now - *firstArrival_).count());
    recordFrame();
  }
  publish();
}

bool TrackingLoop::iterateOnce() {
  if (!run_->frames() && !takeFrame()) {
    return false;
  }
  iterationTimes_.push_back(run_->iterate());
  log_.countIteration(1e-6 * iterationTimes_.back());
  keepNewest(iterationTimes_, kTimesKept);
  frameFresh_ = false;
  std::vector<IterationRecord> records;
  for (std::size_t k = 0; k < run_->estimates().size(); ++k) {
    const auto& estimate = run_->estimates()[k];
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
    if (const auto truth = truth_.at(run_->targets()[k].name, record.frame)) {
      record.error = (estimate.mean - *truth).norm();
    }
    records.push_back(record);
  }
  log_.append(records);
  return true;
}

void TrackingLoop::recordFrame() {
  const bool again = recordedFrame_ == run_->frames()->index;
  recordedFrame_ = run_->frames()->index;
  log_.append(run_->samples());
  for (std::size_t k = 0; k < tails_.size(); ++k) {
    if (again) {
      tails_[k].pop_back();
    }
    tails_[k].push_back(run_->estimates()[k].mean);
    keepNewest(tails_[k], kTailLength);
  }
}

std::vector<cv::Mat> TrackingLoop::masks() const {
  std::vector<cv::Mat> masks;
  for (const auto& frame : run_->frames()->frames) {
    cv::Mat mask;
    for (const auto& target : run_->targets()) {
      if (frame) {
        const cv::Mat matched = matchImage(frame->image, ColorClassifier(target.color));
        mask = mask.empty() ? matched : cv::Mat(mask | matched);
      }
    }
    masks.push_back(mask);
  }
  return masks;
}

void TrackingLoop::publish() {
  auto snapshot = std::make_shared<TrackSnapshot>();
  snapshot->rig = rig_;
  snapshot->seed = project_.seed;
  snapshot->state = state_;
  snapshot->notices = errors_;
  if (source_) {
    const auto more = source_->notices();
    snapshot->notices.insert(snapshot->notices.end(), more.begin(), more.end());
    snapshot->frameCount = source_->frameCount();
    snapshot->droppedFrames = source_->droppedFrames();
  }
  if (run_) {
    snapshot->frames = run_->frames();
    snapshot->iterations = run_->iterations();
    snapshot->targets = run_->snapshots(kParticlesShown);
    for (std::size_t k = 0; k < snapshot->targets.size(); ++k) {
      snapshot->targets[k].tail.assign(tails_[k].begin(), tails_[k].end());
    }
  }
  if (snapshot->frames) {
    snapshot->frame = snapshot->frames->index;
    for (auto& target : snapshot->targets) {
      target.truth = truth_.at(target.target.name, snapshot->frame);
    }
    if (masksWanted_) {
      snapshot->masks = masks();
    }
  }
  if (frameTimes_.size() > 1) {
    const std::chrono::duration<double> span = frameTimes_.back() - frameTimes_.front();
    snapshot->framesPerSecond =
        static_cast<double>(frameTimes_.size() - 1) / std::max(1e-9, span.count());
  }
  snapshot->microsecondsPerIteration = median(iterationTimes_);
  snapshot->latency = log_.latency();
  log_.setFinished(state_ == PlayState::Ended);
  publisher_.publish(std::move(snapshot));
}

} // namespace dewpoint

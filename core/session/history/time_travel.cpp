// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/history/time_travel.h"

#include "core/tracking/people/people_targets.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace dewpoint::session {
namespace {

/// Particles kept of each target and frame.
constexpr int kParticlesKept = 500;
constexpr std::size_t kTailLength = 256;
constexpr int kMapReach = 48; ///< pixels

TargetSnapshot snapshotOf(const TrackedTarget& moment, const Target& target) {
  TargetSnapshot shown;
  shown.target = target;
  shown.estimate = moment.estimate;
  shown.particles = moment.particles.cast<double>();
  shown.weights = moment.weights.cast<double>();
  shown.proposals = moment.proposals;
  shown.reasons = moment.reasons;
  shown.status = moment.status;
  shown.box = moment.box;
  shown.person = moment.person;
  return shown;
}

} // namespace

TimeTravel::TimeTravel(FrameSetSource& source, std::size_t bytes)
    : live_(source.isLive()), history_(HistoryLimits::of(bytes, live_)) {
  const std::size_t most = history_.limits().frames;
  library_ = live_ ? liveFrames(most) : recordedFrames(source, most);
}

void TimeTravel::clear() {
  history_.clear();
  library_->clear();
  probe_.reset();
  probeNext_.reset();
}

void TimeTravel::beforeFrame(const FrameSetPtr& frames, const TrackingRun& run) {
  library_->add(frames);
  if (live_) {
    history_.forgetBefore(library_->oldest());
  }
  history_.beforeFrame(frames->index, run);
}

void TimeTravel::changed(const TrackingRun& run, const RunChange& change) {
  if (run.frames()) {
    history_.changed(run.frames()->index, run.frameIterations(), change);
  }
}

const TrackedFrame& TimeTravel::record(const TrackingRun& run) {
  const std::int64_t frame = run.frames()->index;
  history_.record(run.moment(kParticlesKept, history_.before(frame)));
  return *history_.newest();
}

std::optional<std::int64_t> TimeTravel::nearest(std::int64_t frame) const {
  const std::int64_t newest = library_->newest();
  return newest < 0 ? std::nullopt : std::optional(std::clamp(frame, library_->oldest(), newest));
}

std::optional<std::int64_t> TimeTravel::following(std::int64_t frame) const {
  return frame < library_->newest() ? nearest(frame + 1) : std::nullopt;
}

Status TimeTravel::show(std::int64_t frame, bool quickly, TrackSnapshot& snapshot) {
  bool exact = true;
  snapshot.frames = quickly ? library_->glance(frame, exact) : nullptr;
  snapshot.preview = snapshot.frames != nullptr && !exact;
  if (!snapshot.frames) {
    auto frames = library_->at(frame);
    if (!frames) {
      return tl::make_unexpected(frames.error());
    }
    snapshot.frames = std::move(*frames);
  }
  snapshot.frame = frame;
  snapshot.targets.clear();
  if (const TrackedFrame* moment = history_.at(frame)) {
    snapshot.tracked = true;
    snapshot.iterations = moment->totalIterations;
    snapshot.peopleCameras = moment->peopleCameras;
    for (std::size_t k = 0; k < moment->targets.size(); ++k) {
      snapshot.targets.push_back(snapshotOf(moment->targets[k], (*moment->definitions)[k]));
      snapshot.targets.back().tail = history_.tail(k, frame, kTailLength);
    }
  }
  return {};
}

HistoryState TimeTravel::state() const {
  HistoryState state;
  state.first = library_->oldest();
  state.last = library_->newest();
  state.bytes = history_.bytes() + library_->bytes();
  state.mostBytes = history_.limits().sum();
  if (const TrackedFrame* newest = history_.newest()) {
    state.head = newest->frame;
  }
  return state;
}

Status TimeTravel::repeat(TrackingRun& run, const TrackedFrame& moment) {
  const auto frames = library_->at(moment.frame);
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  run.beginFrame(*frames);
  for (int done = 0; done <= moment.iterations; ++done) {
    for (const RunChange& change : history_.changesAt(moment.frame, done)) {
      run.apply(change);
    }
    if (done < moment.iterations) {
      run.iterate();
    }
  }
  return {};
}

bool TimeTravel::bringNear(TrackingRun& run, std::int64_t frame, std::uint64_t seed,
                           std::int64_t& next) const {
  if (const History::Checkpoint* checkpoint = history_.checkpointFor(frame)) {
    run.restore(checkpoint->state);
    next = checkpoint->frame;
    return true;
  }
  // A method that cannot be copied goes over everything again, as long as there are images.
  const auto& begun = history_.begun();
  const bool again =
      begun && begun->frame < frame && begun->frame >= library_->oldest() && !run.canBeCopied();
  next = again ? begun->frame : frame;
  if (again) {
    run.apply({begun->state.parameters, begun->state.targets, begun->state.rig});
  }
  const TrackedFrame* before = history_.before(next);
  run.restart(seed);
  run.countFrom(before != nullptr ? before->totalIterations : 0);
  return again;
}

Result<std::int64_t> TimeTravel::goBack(TrackingRun& run, std::int64_t frame, std::uint64_t seed,
                                        const GoOn& goOn) {
  std::int64_t next = frame;
  if (!bringNear(run, frame, seed, next)) {
    return frame;
  }
  const TrackedFrame* moment = history_.at(next);
  moment = moment != nullptr ? moment : history_.after(next);
  for (; moment != nullptr && moment->frame < frame; moment = history_.after(moment->frame)) {
    if (!goOn()) {
      return moment->frame;
    }
    if (const auto repeated = repeat(run, *moment); !repeated) {
      return tl::make_unexpected(repeated.error());
    }
  }
  return frame;
}

void TimeTravel::addMaps(const TrackingRun& run, TrackSnapshot& snapshot) {
  if (run.people() != nullptr) {
    return; // their masks are what the images say
  }
  for (std::size_t k = 0; k < snapshot.targets.size(); ++k) {
    snapshot.targets[k].maps = run.likelihoodMaps(k, kMapReach);
  }
}

void TimeTravel::addMaps(const Project& project, std::int64_t frame, bool masks,
                         TrackSnapshot& snapshot, const GoOn& goOn) {
  const TrackedFrame* moment = history_.at(frame);
  if (moment == nullptr) {
    return;
  }
  const History::Checkpoint* checkpoint = history_.checkpointFor(frame);
  const bool near = probe_ && probeNext_ && *probeNext_ <= frame && checkpoint != nullptr &&
                    *probeNext_ >= checkpoint->frame;
  if (!near) {
    auto run = TrackingRun::create(project, 1);
    if (!run || checkpoint == nullptr) {
      return;
    }
    probe_.emplace(std::move(*run));
    probe_->restore(checkpoint->state);
    probeNext_ = checkpoint->frame;
  }
  const TrackedFrame* next = history_.at(*probeNext_);
  next = next != nullptr ? next : history_.after(*probeNext_);
  for (; next != nullptr && next->frame <= frame; next = history_.after(next->frame)) {
    if (!goOn() || !repeat(*probe_, *next)) {
      probe_.reset();
      return;
    }
    probeNext_ = next->frame + 1;
  }
  addMaps(*probe_, snapshot);
  if (masks && probe_->people() != nullptr) {
    snapshot.masks = motionMasks(*probe_);
  }
}

std::vector<cv::Mat> motionMasks(const TrackingRun& run) {
  std::vector<cv::Mat> masks;
  for (std::size_t camera = 0; camera < run.rig().size(); ++camera) {
    cv::Mat mask = run.people()->tracker().foreground(camera);
    const Intrinsics& size = run.rig()[camera].intrinsics;
    if (!mask.empty() && mask.size() != cv::Size(size.width, size.height)) {
      cv::Mat larger;
      cv::resize(mask, larger, cv::Size(size.width, size.height), 0.0, 0.0, cv::INTER_NEAREST);
      mask = larger;
    }
    masks.push_back(mask);
  }
  return masks;
}

} // namespace dewpoint::session

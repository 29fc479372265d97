// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/rewind/history.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace dewpoint::session {
namespace {

constexpr std::int64_t kFirstSpacing = 15; ///< frames between copies, as long as there is room

bool hasParticles(const TrackedFrame& trackedFrame) {
  return std::ranges::any_of(trackedFrame.targets, [](const auto& target) {
    return target.particles.size() > 0 || target.boxParticles.centers.size() > 0;
  });
}

/// Whether nothing but the cameras is otherwise.
bool isOfCameras(const DefinitionChange& change) {
  RunDefinition moved = *change.before;
  moved.rig = change.after->rig;
  return moved == *change.after;
}

} // namespace

Eigen::Vector3d tailPosition(const TrackEstimate& estimate) {
  const auto position = isConfirmed(estimate) ? positionOf(estimate) : std::nullopt;
  return position ? position->mean
                  : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

HistoryLimits HistoryLimits::forTotal(std::size_t total, bool live) {
  const std::size_t frames = live ? total / 4 * 3 : total / 4;
  const std::size_t copies = live ? total / 8 : total / 4;
  return {frames, total - frames - copies, copies};
}

void History::clear() {
  trackedFrames_.clear();
  trackedFrameBytes_ = 0;
  checkpoints_.clear();
  checkpointBytes_ = 0;
  spacing_ = 0;
  changes_.clear();
  methodStart_.reset();
  tailBegins_.clear();
}

void History::noteFrameBegin(std::int64_t frame, const TrackingRun& run) {
  if (!methodStart_) {
    methodStart_ = Checkpoint{frame, {nullptr, run.definition(), run.iterationCount(), 0}};
  }
  const bool due = checkpoints_.empty() || frame >= checkpoints_.rbegin()->first + spacing_;
  if (!due || checkpoints_.contains(frame)) {
    return;
  }
  Checkpoint checkpoint{frame, run.save()};
  if (!checkpoint.state.tracker) {
    return; // a method that cannot be copied
  }
  spacing_ = std::max(spacing_, kFirstSpacing);
  checkpointBytes_ += checkpoint.state.memoryBytes;
  checkpoints_.emplace(frame, std::move(checkpoint));
  while (checkpointBytes_ > limits_.checkpointBytes && checkpoints_.size() > 2) {
    thinCheckpoints();
  }
}

void History::thinCheckpoints() {
  bool wanted = true; // the first stays
  for (auto found = checkpoints_.begin(); found != checkpoints_.end(); wanted = !wanted) {
    if (wanted || std::next(found) == checkpoints_.end()) {
      ++found;
      continue;
    }
    checkpointBytes_ -= found->second.state.memoryBytes;
    found = checkpoints_.erase(found);
  }
  spacing_ *= 2;
}

void History::recordChange(std::int64_t frame, int iterations, const RunChange& change) {
  std::vector<RunChange>& there = changes_[{frame, iterations}];
  const auto* next = std::get_if<DefinitionChange>(&change);
  auto* last = there.empty() ? nullptr : std::get_if<DefinitionChange>(&there.back());
  // A camera that is dragged, unless it is back where it was: each step is something to a method.
  if (next != nullptr && last != nullptr && isOfCameras(*last) && isOfCameras(*next) &&
      *last->before->rig != *next->after->rig) {
    last->after = next->after;
  } else {
    there.push_back(change);
  }
}

void History::record(TrackedFrame trackedFrame) {
  if (!trackedFrames_.empty() && trackedFrames_.back().frame == trackedFrame.frame) {
    trackedFrameBytes_ -= trackedFrames_.back().memoryBytes();
    trackedFrames_.pop_back();
  }
  trackedFrameBytes_ += trackedFrame.memoryBytes();
  trackedFrames_.push_back(std::move(trackedFrame));
  if (trackedFrameBytes_ > limits_.trackedFrameBytes) {
    thinTrackedFrames();
  }
}

void History::thinTrackedFrames() {
  const std::size_t half = trackedFrames_.size() / 2;
  bool wanted = true;
  for (std::size_t k = 0; k < half; ++k) {
    TrackedFrame& trackedFrame = trackedFrames_[k];
    if (hasParticles(trackedFrame) && !(wanted = !wanted)) {
      forgetParticles(trackedFrame);
    }
  }
  // A run is repeated through its moments: none is given up while there are particles to give up.
  for (auto trackedFrame = trackedFrames_.begin(); trackedFrameBytes_ > limits_.trackedFrameBytes &&
                                                   trackedFrame != std::prev(trackedFrames_.end());
       ++trackedFrame) {
    if (hasParticles(*trackedFrame)) {
      forgetParticles(*trackedFrame);
    }
  }
  while (trackedFrameBytes_ > limits_.trackedFrameBytes && trackedFrames_.size() > 1) {
    trackedFrameBytes_ -= trackedFrames_.front().memoryBytes(); // estimates alone fill the memory
    trackedFrames_.pop_front();
  }
}

void History::forgetParticles(TrackedFrame& trackedFrame) {
  trackedFrameBytes_ -= trackedFrame.memoryBytes();
  for (TrackedTarget& target : trackedFrame.targets) {
    target.particles.resize(0, 3);
    target.weights.resize(0);
    target.positionCandidates = {};
    target.boxParticles.centers.resize(0, 2);
    target.boxParticles.weights.resize(0);
  }
  trackedFrameBytes_ += trackedFrame.memoryBytes();
}

void History::forgetFrom(std::int64_t frame) {
  while (!trackedFrames_.empty() && trackedFrames_.back().frame >= frame) {
    trackedFrameBytes_ -= trackedFrames_.back().memoryBytes();
    trackedFrames_.pop_back();
  }
  for (auto found = checkpoints_.upper_bound(frame); found != checkpoints_.end();) {
    checkpointBytes_ -= found->second.state.memoryBytes;
    found = checkpoints_.erase(found);
  }
  changes_.erase(changes_.lower_bound({frame, 0}), changes_.end());
  tailBegins_.erase(tailBegins_.lower_bound(frame), tailBegins_.end());
  if (methodStart_ && methodStart_->frame >= frame) {
    methodStart_.reset();
  }
}

void History::removeCheckpoints() {
  checkpoints_.clear();
  checkpointBytes_ = 0;
  spacing_ = 0;
  changes_.clear();
  methodStart_.reset();
}

void History::forgetBefore(std::int64_t frame) {
  while (!trackedFrames_.empty() && trackedFrames_.front().frame < frame) {
    trackedFrameBytes_ -= trackedFrames_.front().memoryBytes();
    trackedFrames_.pop_front();
  }
  while (!checkpoints_.empty() && checkpoints_.begin()->first < frame) {
    checkpointBytes_ -= checkpoints_.begin()->second.state.memoryBytes;
    checkpoints_.erase(checkpoints_.begin());
  }
  changes_.erase(changes_.begin(), changes_.lower_bound({frame, 0}));
}

std::deque<TrackedFrame>::const_iterator History::lowerBound(std::int64_t frame) const {
  return std::lower_bound(trackedFrames_.begin(), trackedFrames_.end(), frame,
                          [](const TrackedFrame& trackedFrame, std::int64_t number) {
                            return trackedFrame.frame < number;
                          });
}

const TrackedFrame* History::at(std::int64_t frame) const {
  const auto found = lowerBound(frame);
  return found != trackedFrames_.end() && found->frame == frame ? &*found : nullptr;
}

const TrackedFrame* History::before(std::int64_t frame) const {
  const auto found = lowerBound(frame);
  return found != trackedFrames_.begin() ? &*std::prev(found) : nullptr;
}

const TrackedFrame* History::after(std::int64_t frame) const {
  const auto found = lowerBound(frame + 1);
  return found != trackedFrames_.end() ? &*found : nullptr;
}

std::vector<Eigen::Vector3d> History::tail(std::size_t target, std::int64_t frame,
                                           std::int64_t end) const {
  const auto begins = tailBegins_.upper_bound(frame);
  const auto first =
      begins != tailBegins_.begin() ? lowerBound(*std::prev(begins)) : trackedFrames_.begin();
  std::vector<Eigen::Vector3d> tail;
  for (auto trackedFrame = lowerBound(end + 1);
       trackedFrame != first && tail.size() < kTailLength;) {
    --trackedFrame;
    if (target >= trackedFrame->targets.size() ||
        !positionOf(trackedFrame->targets[target].estimate)) {
      break;
    }
    tail.push_back(tailPosition(trackedFrame->targets[target].estimate));
  }
  std::ranges::reverse(tail);
  return tail;
}

const History::Checkpoint* History::checkpointFor(std::int64_t frame) const {
  const auto next = checkpoints_.upper_bound(frame);
  return next != checkpoints_.begin() ? &std::prev(next)->second : nullptr;
}

std::vector<RunChange> History::changesAt(std::int64_t frame, int iterations) const {
  const auto found = changes_.find({frame, iterations});
  return found != changes_.end() ? found->second : std::vector<RunChange>();
}

} // namespace dewpoint::session

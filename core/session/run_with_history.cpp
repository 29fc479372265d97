// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run_with_history.h"

#include <memory>
#include <utility>

namespace dewpoint::session {
namespace {

// Bytes of history unless requested otherwise. Chosen: minutes of a few particle filters, in a
// small part of a usual machine's memory; what live cameras showed can be had from nowhere else.
constexpr std::size_t kRecordedHistory = std::size_t{512} << 20;
constexpr std::size_t kLiveHistory = std::size_t{1024} << 20;

} // namespace

RunWithHistory::RunWithHistory(RunDefinition definition, int threadCount)
    : threadCount_(threadCount),
      definition_(std::make_shared<const RunDefinition>(std::move(definition))) {}

Status RunWithHistory::startNewRun(RunDefinition definition, std::int64_t iterations) {
  definition.adaptParametersToCameras();
  auto made = std::make_shared<const RunDefinition>(std::move(definition));
  auto run = TrackingRun::create(made, threadCount_);
  if (!run) {
    return tl::make_unexpected(run.error());
  }
  run->setIterationCount(iterations);
  definition_ = std::move(made);
  run_.emplace(std::move(*run));
  return {};
}

void RunWithHistory::keepHistory(FrameSetSource& source, std::size_t bytes) {
  const std::size_t usual = source.isLive() ? kLiveHistory : kRecordedHistory;
  travel_.emplace(source, bytes > 0 ? bytes : usual);
}

void RunWithHistory::beginFrame(const FrameSetPtr& frames) {
  travel_->noteFrameBegin(frames, *run_);
  run_->beginFrame(frames);
}

bool RunWithHistory::change(RunDefinition wanted) {
  if (!run_->accepts(wanted)) {
    return false;
  }
  wanted.adaptParametersToCameras();
  if (wanted == *definition_) {
    return true;
  }
  const RunDefinitionPtr before =
      std::exchange(definition_, std::make_shared<const RunDefinition>(std::move(wanted)));
  run_->apply(definition_);
  travel_->recordChange(*run_, DefinitionChange{before, definition_});
  return true;
}

void RunWithHistory::change(const RunChange& runChange) {
  run_->apply(runChange);
  travel_->recordChange(*run_, runChange);
}

Status RunWithHistory::goBack(std::int64_t frame, bool isLive) {
  const History& history = travel_->history();
  const History::Checkpoint* copy = history.checkpointFor(frame);
  const bool knewNothing = history.before(frame) == nullptr &&
                           (copy != nullptr ? copy->state.iterationCount == 0 : frame == 0);
  if (knewNothing && !isLive) { // live: what was there before may be forgotten
    return startNewRun(*definition_, 0).map([this] { travel_->removeCheckpoints(); });
  }
  const auto reached = travel_->goBack(*run_, frame, [] { return true; });
  return reached ? Status() : Status(tl::make_unexpected(reached.error()));
}

void RunWithHistory::applyLaterChanges() {
  if (const RunDefinitionPtr then = run_->definition(); *then != *definition_) {
    run_->apply(definition_);
    travel_->recordChange(*run_, DefinitionChange{then, definition_});
  }
}

void RunWithHistory::setThreadCount(int threadCount) {
  threadCount_ = threadCount;
  run_->setThreadCount(threadCount);
  if (travel_) {
    travel_->setThreadCount(threadCount);
  }
}

void RunWithHistory::restart(std::optional<std::uint64_t> seed) {
  if (seed) {
    RunDefinition other = *definition_;
    other.seed = *seed;
    definition_ = std::make_shared<const RunDefinition>(std::move(other));
    run_->apply(definition_);
  }
  run_->restart(definition_->seed);
  travel_->clear();
}

} // namespace dewpoint::session

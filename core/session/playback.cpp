// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/playback.h"

#include "core/base/overloaded.h"

#include <algorithm>
#include <utility>

namespace dewpoint::session {
namespace {

/// The head, paused or ended.
Playback::State waiting(bool inputEnded) {
  return inputEnded ? Playback::State(Playback::Ended{}) : Playback::State(Playback::Paused{});
}

Playback::State headState(PlayState state) {
  switch (state) {
  case PlayState::Paused:
    return Playback::Paused{};
  case PlayState::Playing:
    return Playback::Playing{};
  case PlayState::Ended:
    return Playback::Ended{};
  }
  return Playback::Paused{};
}

} // namespace

PlayState Playback::playState() const {
  return std::visit(Overloaded{[](const Paused&) { return PlayState::Paused; },
                               [](const Playing&) { return PlayState::Playing; },
                               [](const Ended&) { return PlayState::Ended; },
                               [](const Viewing&) { return PlayState::Paused; },
                               [](const Replaying&) { return PlayState::Playing; },
                               [](const Rerunning&) { return PlayState::Playing; },
                               [](const Holding&) { return PlayState::Paused; }},
                    state_);
}

std::optional<std::int64_t> Playback::viewedFrame() const {
  if (const auto* viewing = std::get_if<Viewing>(&state_)) {
    return viewing->frame;
  }
  const auto* replaying = std::get_if<Replaying>(&state_);
  return replaying != nullptr ? std::optional(replaying->frame) : std::nullopt;
}

const Playback::Rerunning* Playback::currentRerun() const {
  const auto* holding = std::get_if<Holding>(&state_);
  return holding != nullptr ? &holding->rerun : std::get_if<Rerunning>(&state_);
}

std::optional<RerunState> Playback::rerunRange() const {
  const Rerunning* underWay = currentRerun();
  return underWay != nullptr ? std::optional(underWay->range) : std::nullopt;
}

bool Playback::hasInputEnded() const {
  return std::visit(Overloaded{[](const Ended&) { return true; },
                               [](const Viewing& viewing) { return viewing.hadInputEnded; },
                               [](const Replaying& replaying) { return replaying.hadInputEnded; },
                               [](const auto&) { return false; }},
                    state_);
}

void Playback::play() {
  if (std::holds_alternative<Paused>(state_)) {
    state_ = Playing{};
  } else if (const auto* viewing = std::get_if<Viewing>(&state_)) {
    state_ = Replaying{viewing->frame, viewing->hadInputEnded};
  } else if (const auto* holding = std::get_if<Holding>(&state_)) {
    state_ = Rerunning(holding->rerun);
  }
}

void Playback::pause() {
  hold();
  if (std::holds_alternative<Holding>(state_)) {
    state_ = Paused{};
  }
}

void Playback::hold() {
  if (std::holds_alternative<Playing>(state_)) {
    state_ = Paused{};
  } else if (const auto* replaying = std::get_if<Replaying>(&state_)) {
    state_ = Viewing{replaying->frame, replaying->hadInputEnded};
  } else if (const auto* rerunning = std::get_if<Rerunning>(&state_)) {
    state_ = Holding{*rerunning};
  }
}

void Playback::show(std::optional<std::int64_t> frame, std::int64_t head) {
  const bool inputEnded = hasInputEnded();
  if (frame && *frame != head) {
    state_ = Viewing{*frame, inputEnded};
  } else {
    state_ = waiting(inputEnded);
  }
}

void Playback::returnToNewestFrame() {
  if (!viewedFrame()) {
    return;
  }
  state_ = isRunning() && !hasInputEnded() ? State(Playing{}) : waiting(hasInputEnded());
}

void Playback::advance(std::optional<std::int64_t> next, std::int64_t head) {
  if (!viewedFrame()) {
    return;
  }
  if (!next) {
    hold();
  } else if (*next == head) {
    returnToNewestFrame();
  } else if (auto* viewing = std::get_if<Viewing>(&state_)) {
    viewing->frame = *next;
  } else {
    std::get<Replaying>(state_).frame = *next;
  }
}

void Playback::rerun(const RerunState& range, std::optional<std::int64_t> frameShownAfterwards) {
  Rerunning next{range,
                 hasInputEnded() ? PlayState::Ended
                 : viewedFrame() ? PlayState::Paused
                                 : playState(),
                 frameShownAfterwards};
  if (const Rerunning* underWay = currentRerun()) {
    next.range.lastFrame = std::max(range.lastFrame, underWay->range.lastFrame);
    next.stateAfterwards = underWay->stateAfterwards;
    next.frameShownAfterwards =
        frameShownAfterwards ? frameShownAfterwards : underWay->frameShownAfterwards;
  }
  state_ = next;
  missingContent_ = MissingContent::Nothing; // of a snapshot that is over
  leaveHead(range.firstFrame);
}

void Playback::continueTrackingAt(std::int64_t frame) {
  state_ = Playing{};
  leaveHead(frame);
}

void Playback::endInput() {
  state_ = Ended{};
}

void Playback::restart() {
  state_ = isRunning() ? State(Playing{}) : State(Paused{});
  leaveHead(0);
}

void Playback::leaveHead(std::int64_t nextFrame) {
  headProgress_ = HeadProgress::None;
  nextFrame_ = nextFrame;
}

void Playback::setHead(std::int64_t frame) {
  headProgress_ = HeadProgress::Taken;
  nextFrame_ = frame + 1;
}

void Playback::noteIteration() {
  if (headProgress_ == HeadProgress::Taken) {
    headProgress_ = HeadProgress::Tracked;
  }
}

std::optional<std::int64_t> Playback::noteFrameReached(std::int64_t head) {
  const Rerunning* underWay = currentRerun();
  if (underWay == nullptr || head < underWay->range.lastFrame) {
    return std::nullopt;
  }
  const Rerunning done = *underWay;
  state_ = headState(done.stateAfterwards);
  return done.frameShownAfterwards;
}

void Playback::forgetEstimates() {
  headProgress_ = headProgress_ == HeadProgress::None ? HeadProgress::None : HeadProgress::Taken;
}

void Playback::notePublished(bool isPreview, bool lacksMaps) {
  missingContent_ = isPreview   ? MissingContent::Images
                    : lacksMaps ? MissingContent::Maps
                                : MissingContent::Nothing;
}

} // namespace dewpoint::session

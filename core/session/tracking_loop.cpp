// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/tracking_loop.h"

#include "core/base/thread_precedence.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace dewpoint::session {
namespace {

constexpr std::chrono::milliseconds kBetweenSnapshots(30);

} // namespace

TrackingLoop::TrackingLoop(SessionInputs inputs)
    : builder_(TruthTable(inputs.truth)), driver_(std::move(inputs), tap_, log_, builder_.truth()) {
}

void TrackingLoop::run(const std::stop_token& stop) {
  setPrecedence(Precedence::Prompt);
  driver_.start();
  publish(Publish::Now);
  while (!stop.stop_requested()) {
    if (const auto command = commands_.pop(stop, deadline())) {
      obey(*command);
      continue;
    }
    if (playback().missing() == Playback::Missing::Images) {
      publish(Publish::Now);
      continue;
    }
    if (playback().missing() == Playback::Missing::Maps) {
      addMaps(stop);
    }
    if (!stop.stop_requested() && playback().goesOn()) {
      planNextFrame();
      driver_.advance();
      publish(usual());
    }
  }
}

std::optional<TrackingLoop::Clock::time_point> TrackingLoop::deadline() const {
  const bool isIncomplete = playback().missing() != Playback::Missing::Nothing;
  if (isIncomplete || (playback().goesOn() && playback().rerunning())) {
    return Clock::now();
  }
  return playback().goesOn() ? std::optional(nextFrameDue_) : std::nullopt;
}

void TrackingLoop::planNextFrame() {
  const auto now = Clock::now();
  const auto period = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(1.0 / std::max(1.0, driver_.framesPerSecond())));
  const bool atOnce = playback().rerunning() || (driver_.isLive() && !playback().viewed());
  nextFrameDue_ = atOnce ? now : std::max(nextFrameDue_ + period, now);
}

void TrackingLoop::publish(Publish how) {
  if (how == Publish::NowAndThen && Clock::now() - published_ < kBetweenSnapshots) {
    return;
  }
  auto snapshot = std::make_shared<TrackSnapshot>();
  driver_.describe(builder_, how == Publish::Quickly, *snapshot);
  published_ = Clock::now();
  publisher_.publish(std::move(snapshot));
}

void TrackingLoop::addMaps(const std::stop_token& stop) {
  auto snapshot = std::make_shared<TrackSnapshot>(*publisher_.newest());
  const auto goOn = [&] { return !stop.stop_requested() && commands_.empty(); };
  driver_.addMaps(builder_, *snapshot, goOn);
  publisher_.publish(std::move(snapshot));
}

void TrackingLoop::obey(const Command& command) {
  if (driver_.isReady()) {
    publish(std::visit([this](const auto& wish) { return handle(wish); }, command));
  }
}

TrackingLoop::Publish TrackingLoop::handle(const command::Play&) {
  driver_.play();
  nextFrameDue_ = Clock::now();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Pause&) {
  driver_.pause();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::StepFrame&) {
  driver_.stepFrame();
  return usual();
}

TrackingLoop::Publish TrackingLoop::handle(const command::StepIteration&) {
  driver_.stepIteration();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Restart& wish) {
  driver_.restart(wish.seed);
  nextFrameDue_ = Clock::now();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Configure& wish) {
  RunDefinition wanted = driver_.definition();
  wanted.parameters = wish.parameters;
  driver_.change(std::move(wanted));
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetMethod& wish) {
  driver_.setMethod(wish);
  nextFrameDue_ = Clock::now();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetTargets& wish) {
  driver_.setTargets(wish.targets);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetCameras& wish) {
  driver_.setCameras(wish.rig);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetEmptyRooms& wish) {
  driver_.setEmptyRooms(wish);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetPeople& wish) {
  driver_.setPeople(wish.people);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetVolumeOfInterest& wish) {
  RunDefinition wanted = driver_.definition();
  wanted.volumeOfInterest = wish.volume;
  driver_.change(std::move(wanted));
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetCorrections& wish) {
  driver_.setCorrections(wish.corrections);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetThreads& wish) {
  driver_.setThreads(wish.threads);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowMasks& wish) {
  builder_.wishes().masks = wish.wanted;
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowMaps& wish) {
  builder_.wishes().maps = wish.wanted;
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowShapes& wish) {
  builder_.wishes().shapes = wish.wanted;
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowBoard& wish) {
  driver_.setBoardShown(wish.shown);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowFrame& wish) {
  driver_.show(wish.frame);
  return Publish::Quickly;
}

TrackingLoop::Publish TrackingLoop::handle(const command::BackToHead&) {
  driver_.returnToHead();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Rerun& wish) {
  driver_.rerun(wish.from);
  return Publish::Now;
}

} // namespace dewpoint::session

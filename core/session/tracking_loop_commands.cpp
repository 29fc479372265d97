// SPDX-License-Identifier: GPL-3.0-or-later
// What the tracking thread is asked to do.
#include "core/session/tracking_loop.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::session {

void TrackingLoop::obey(const Command& command) {
  if (!run_ || !source_) {
    return;
  }
  switch (std::visit([this](const auto& wish) { return handle(wish); }, command)) {
  case Publish::Done:
    break;
  case Publish::Now:
    publish();
    break;
  case Publish::Quickly:
    publish(true);
    break;
  }
}

TrackingLoop::Publish TrackingLoop::handle(const command::Play&) {
  if (view_ && *view_ > head()) {
    rerun(*view_); // from a part that was not tracked yet
  } else if (view_ || !atEnd_ || restart(std::nullopt)) {
    state_ = PlayState::Playing;
  }
  nextFrameDue_ = Clock::now();
  frameTimes_.clear();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Pause&) {
  state_ = state_ == PlayState::Ended ? state_ : PlayState::Paused;
  rerun_.reset();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::StepFrame&) {
  state_ = state_ == PlayState::Ended ? state_ : PlayState::Paused;
  if (view_) {
    showNext();
    return Publish::Done;
  }
  if (state_ != PlayState::Ended) {
    iterateFrame();
    return Publish::Done;
  }
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::StepIteration&) {
  backToHead();
  state_ = state_ == PlayState::Ended ? state_ : PlayState::Paused;
  if (iterateOnce()) {
    recordFrame();
  }
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Restart& wish) {
  restart(wish.seed);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Configure& wish) {
  project_.parameters = wish.parameters;
  run_->configure(wish.parameters);
  travel_->changed(*run_, {wish.parameters, std::nullopt, std::nullopt});
  log_.change(project_);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetMethod& wish) {
  if (wish.from) {
    rerun(*wish.from, &wish);
  } else {
    changeMethod(wish);
  }
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetTargets& wish) {
  changeTargets(wish.targets);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetCameras& wish) {
  changeCameras(wish.rig);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::SetEmptyRooms& wish) {
  changeEmptyRooms(wish);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ChangePeople& wish) {
  changePeople(wish);
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowMasks& wish) {
  masksWanted_ = wish.wanted;
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowMaps& wish) {
  mapsWanted_ = wish.wanted;
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowShapes& wish) {
  shapesWanted_ = wish.wanted;
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::ShowFrame& wish) {
  show(wish.frame);
  return Publish::Quickly;
}

TrackingLoop::Publish TrackingLoop::handle(const command::BackToHead&) {
  backToHead();
  return Publish::Now;
}

TrackingLoop::Publish TrackingLoop::handle(const command::Rerun& wish) {
  rerun(wish.from);
  return Publish::Now;
}

void TrackingLoop::changeMethod(const command::SetMethod& wish) {
  Project changed = project_;
  changed.method = wish.method;
  changed.parameters = wish.parameters;
  changed.targets = run_->projectTargets();
  auto run = TrackingRun::create(changed, 1, emptyRooms_);
  if (!run) {
    errors_.push_back(run.error());
    return;
  }
  project_ = std::move(changed);
  run_.emplace(std::move(*run));
  tails_.clear();
  restart(std::nullopt);
}

void TrackingLoop::changeTargets(const std::vector<Target>& targets) {
  if (run_->family() == MethodFamily::Boxes) {
    changeBoxes(targets);
    return;
  }
  project_.targets = targets;
  if (run_->people() != nullptr || targets.size() == run_->targets().size()) {
    run_->setTargets(targets);
    travel_->changed(*run_, {std::nullopt, targets, std::nullopt});
    return;
  }
  // Another number of targets: new beliefs, on the frame that the run stands at.
  auto run = TrackingRun::create(project_, 1, emptyRooms_);
  if (!run) {
    errors_.push_back(run.error());
    return;
  }
  const FrameSetPtr frames = run_->frames();
  run->countFrom(run_->iterations());
  run_.emplace(std::move(*run));
  travel_->forgetCopies();
  tails_.assign(targets.size(), {});
  recordedFrame_.reset(); // the new tails have nothing of this frame
  if (frames) {
    travel_->beforeFrame(frames, *run_);
    run_->beginFrame(frames);
    frameFresh_ = true;
  }
}

void TrackingLoop::changeCameras(const CameraRig& rig) {
  if (!haveSameImages(rig, *rig_)) {
    return;
  }
  for (std::size_t k = 0; k < rig.size(); ++k) {
    project_.cameras[k].camera = rig[k];
  }
  rig_ = std::make_shared<const CameraRig>(rig);
  run_->setCameras(rig);
  bumps_.setCameras(rig);
  travel_->changed(*run_, {std::nullopt, std::nullopt, rig});
  log_.change(project_);
}

void TrackingLoop::changeEmptyRooms(const command::SetEmptyRooms& wish) {
  if (wish.rooms.size() != project_.cameras.size()) {
    return;
  }
  for (std::size_t k = 0; k < wish.files.size(); ++k) {
    project_.cameras[k].emptyRoom = wish.files[k];
  }
  emptyRooms_ = wish.rooms;
  run_->setEmptyRooms(emptyRooms_);
  travel_->changed(*run_, {std::nullopt, std::nullopt, std::nullopt, emptyRooms_});
  log_.change(project_);
}

bool TrackingLoop::restart(std::optional<std::uint64_t> seed) {
  project_.seed = seed.value_or(project_.seed);
  errors_.clear();
  run_->restart(project_.seed);
  log_.restart(project_);
  travel_->clear();
  if (!source_->isLive()) { // live cameras stay where they are; the calibrated place is still known
    bumps_.restart();
  }
  view_.reset();
  rerun_.reset();
  atEnd_ = false;
  next_ = 0;
  firstArrival_.reset();
  for (auto& tail : tails_) {
    tail.clear();
  }
  iterationTimes_.clear();
  budget_ = {};
  frameTimes_.clear();
  frameFresh_ = false;
  recordedFrame_.reset();
  if (const auto sought = source_->seek(0); !sought) {
    errors_.push_back(sought.error());
    reachEnd();
    return false;
  }
  if (state_ == PlayState::Ended) {
    state_ = PlayState::Paused;
  }
  takeFrame();
  nextFrameDue_ = Clock::now();
  return state_ != PlayState::Ended;
}

void TrackingLoop::show(std::int64_t frame) {
  state_ = PlayState::Paused;
  rerun_.reset();
  const auto nearest = travel_->nearest(frame);
  if (!nearest || *nearest == head()) {
    backToHead();
  } else {
    view_ = nearest;
  }
}

void TrackingLoop::backToHead() {
  view_.reset();
  if (state_ == PlayState::Paused && atEnd_) {
    state_ = PlayState::Ended;
  }
}

void TrackingLoop::showNext() {
  const auto next = travel_->following(*view_);
  view_ = next ? next : view_;
  if (!next) {
    state_ = PlayState::Paused;
  }
  if (*view_ == head()) {
    view_.reset();
    state_ = atEnd_ ? PlayState::Ended : state_;
  }
  publish();
}

std::string TrackingLoop::differences(const Project& before) const {
  std::string text;
  const auto add = [&text](const std::string& key, const auto& value) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : "; ", key, value);
  };
  const bool otherMethod = before.method != project_.method;
  if (otherMethod) {
    add("method", project_.method);
  }
  for (const auto& declaration : project_.parameters.declarations()) {
    const double value = project_.parameters.at(declaration.key);
    if (otherMethod || before.parameters.at(declaration.key) != value) {
      add(declaration.key, value);
    }
  }
  for (std::size_t k = 0; k < std::min(before.targets.size(), run_->projectTargets().size()); ++k) {
    const Target& target = run_->projectTargets()[k];
    if (!(before.targets[k] == target)) {
      if (run_->family() == MethodFamily::Boxes) {
        add(target.name, target.box ? "another box" : "no box");
        continue;
      }
      const ColorRange& color = target.color;
      add(target.name,
          fmt::format("hue {} to {}, saturation {} to {}, intensity {} to {}, radius {} m",
                      color.hueMin, color.hueMax, color.saturationMin, color.saturationMax,
                      color.intensityMin, color.intensityMax, target.radius));
    }
  }
  for (std::size_t k = 0; k < std::min(before.cameras.size(), project_.cameras.size()); ++k) {
    if (!(before.cameras[k].camera == project_.cameras[k].camera)) {
      add(project_.cameras[k].camera.name, "another calibration");
    }
    if (before.cameras[k].emptyRoom != project_.cameras[k].emptyRoom) {
      add(project_.cameras[k].camera.name, "another empty room");
    }
  }
  return text;
}

bool TrackingLoop::goBackTo(std::int64_t from, const command::SetMethod* method) {
  if (method != nullptr) {
    Project changed = project_;
    changed.method = method->method;
    changed.parameters = method->parameters;
    changed.targets = run_->projectTargets();
    auto run = TrackingRun::create(changed, 1, emptyRooms_);
    if (!run) {
      errors_.push_back(run.error());
      return false;
    }
    const TrackedFrame* before = travel_->history().before(from);
    run->countFrom(before != nullptr ? before->totalIterations : 0);
    project_ = std::move(changed);
    run_.emplace(std::move(*run));
    travel_->forgetCopies();
    return true;
  }
  const auto goOn = [] { return true; };
  if (const auto reached = travel_->goBack(*run_, from, project_.seed, goOn); !reached) {
    errors_.push_back(reached.error());
    reachEnd();
    return false;
  }
  return true;
}

/// Where tracking by another method begins so that it can be tracked at `from`.
std::int64_t TrackingLoop::beginOf(const command::SetMethod& method, std::int64_t from) const {
  const MethodFamily family = methodFamily(method.method);
  // Another family follows other things; and people need the background learned at the beginning.
  if (family != run_->family() || family == MethodFamily::People) {
    return travel_->nearest(0).value_or(from);
  }
  if (family == MethodFamily::Boxes) {
    for (const Target& target : run_->targets()) { // they begin at their boxes
      from = target.box ? std::min(from, travel_->nearest(target.box->frame).value_or(from)) : from;
    }
  }
  return from;
}

void TrackingLoop::rerun(std::int64_t from, const command::SetMethod* method) {
  const auto nearest = travel_->nearest(from);
  if (!nearest) {
    return;
  }
  from = method != nullptr ? beginOf(*method, *nearest) : *nearest;
  const auto lookingAt = method != nullptr ? view_ : std::nullopt;
  errors_.clear();
  const bool isPast = from <= head();
  const PlayState waiting = atEnd_ ? PlayState::Ended : PlayState::Paused;
  const Rerun again{{from, head()}, view_ || atEnd_ ? waiting : state_, atEnd_, lookingAt};
  const std::vector<Target> targets = run_->projectTargets();
  Project before = project_;
  before.targets = targets;
  if ((isPast || method != nullptr) && !goBackTo(from, method)) {
    return;
  }
  if (isPast) {
    if (method == nullptr) {
      before.parameters = run_->parameters();
      before.targets = run_->projectTargets();
      for (std::size_t k = 0; k < before.cameras.size(); ++k) {
        before.cameras[k].camera = run_->rig()[k];
      }
    }
    travel_->forgetFrom(from);
    log_.goBack(from);
    rerun_ = again;
  }
  tails_.resize(run_->targets().size());
  for (std::size_t k = 0; k < tails_.size(); ++k) {
    const auto tail = travel_->history().tail(k, from - 1, 256);
    tails_[k].assign(tail.begin(), tail.end());
  }
  view_.reset();
  atEnd_ = false;
  frameFresh_ = false;
  recordedFrame_.reset();
  next_ = from;
  state_ = PlayState::Playing;
  if (!takeFrame()) {
    return;
  }
  // What changed since then holds from this frame on.
  RunChange change;
  if (!(run_->parameters() == project_.parameters)) {
    change.parameters = project_.parameters;
  }
  if (run_->projectTargets() != targets) {
    change.targets = targets;
  }
  if (run_->rig() != *rig_) {
    change.rig = *rig_;
  }
  if (change.parameters || change.targets || change.rig) {
    run_->apply(change);
    travel_->changed(*run_, change);
  }
  log_.note(from, differences(before));
  log_.change(project_);
}

void TrackingLoop::finishRerun() {
  state_ = rerun_->afterwards;
  atEnd_ = rerun_->atEnd;
  const auto lookingAt = rerun_->lookingAt;
  rerun_.reset();
  nextFrameDue_ = Clock::now();
  if (lookingAt) {
    show(*lookingAt);
  }
}

} // namespace dewpoint::session

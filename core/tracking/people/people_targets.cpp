// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_targets.h"

#include "core/filter/evenly_picked.h"

#include <algorithm>
#include <utility>

namespace dewpoint::tracking {
namespace {

constexpr double kHeldExistence = 0.5; ///< below it a person is searched for

TargetEstimate nobody() {
  TargetEstimate estimate;
  estimate.gone = true;
  return estimate;
}

TargetEstimate estimateOf(const PersonEstimate& person) {
  TargetEstimate estimate;
  estimate.mean = person.position;
  estimate.best = person.position;
  estimate.covariance = person.covariance;
  estimate.effectiveSampleSize = person.effectiveSampleSize;
  estimate.particleCount = person.particleCount;
  estimate.camerasSeeing = person.camerasSeeing;
  estimate.existence = person.existence;
  estimate.valid = person.existence >= kHeldExistence;
  return estimate;
}

} // namespace

PeopleTargets::PeopleTargets(std::unique_ptr<PeopleTracker> tracker)
    : tracker_(std::move(tracker)) {}

void PeopleTargets::configure(const ParameterValues& parameters) {
  tracker_->configure(parameters);
}

void PeopleTargets::restart(std::uint64_t seed) {
  tracker_->restart(seed);
  targets_.clear();
  estimates_.clear();
  bodies_.clear();
  frames_ = nullptr;
  stepped_ = false;
}

void PeopleTargets::beginFrame(FrameSetPtr frames) {
  frames_ = std::move(frames);
  stepped_ = false;
}

void PeopleTargets::iterate(ThreadTeam& team) {
  if (frames_ && !std::exchange(stepped_, true)) {
    tracker_->step(frames_, team);
    describe();
  }
}

void PeopleTargets::describe() {
  bodies_.clear();
  for (TargetEstimate& estimate : estimates_) {
    estimate = nobody();
  }
  for (const PersonEstimate& person : tracker_->people()) {
    while (static_cast<int>(targets_.size()) < person.identity) {
      Target& target = targets_.emplace_back();
      target.name = personName(static_cast<int>(targets_.size()));
      estimates_.push_back(nobody());
    }
    estimates_[static_cast<std::size_t>(person.identity - 1)] = estimateOf(person);
  }
}

const PersonEstimate* PeopleTargets::person(std::size_t target) const {
  const auto& people = tracker_->people();
  const auto found =
      std::ranges::find(people, static_cast<int>(target) + 1, &PersonEstimate::identity);
  return found == people.end() ? nullptr : &*found;
}

void PeopleTargets::particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                              Eigen::ArrayXd& weights) const {
  positions.resize(0, 3);
  weights.resize(0);
  if (person(target) == nullptr) {
    return;
  }
  const int identity = static_cast<int>(target) + 1;
  auto known = bodies_.find(identity);
  if (known == bodies_.end()) {
    known = bodies_.emplace(identity, tracker_->body(identity)).first;
  }
  const BodyCloud& body = known->second;
  pickEvenly(body.points, body.weights, limit, 3, positions, weights);
}

std::unique_ptr<MultiTracker> PeopleTargets::clone() const {
  std::unique_ptr<PeopleTracker> copy = tracker_->clone();
  if (!copy) {
    return nullptr;
  }
  auto result = std::make_unique<PeopleTargets>(std::move(copy));
  result->frames_ = frames_;
  result->stepped_ = stepped_;
  result->targets_ = targets_;
  result->estimates_ = estimates_;
  return result;
}

std::size_t PeopleTargets::memoryBytes() const {
  return tracker_->memoryBytes() + targets_.capacity() * (sizeof(Target) + sizeof(TargetEstimate));
}

int PeopleTargets::addPerson(const Eigen::Vector3d& middle) {
  const int identity = tracker_->addPerson(middle);
  describe();
  return identity;
}

void PeopleTargets::removePerson(int identity) {
  tracker_->removePerson(identity);
  describe();
}

} // namespace dewpoint::tracking

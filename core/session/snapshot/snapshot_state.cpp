// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/snapshot_state.h"

#include "core/base/overloaded.h"
#include "core/capture/image_shape.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <limits>
#include <variant>

namespace dewpoint::session {

namespace {

/// Whether an outline goes around a point: a line to the left crosses it an odd number of times.
bool isWithin(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& point) {
  bool within = false;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Eigen::Vector2d& from = outline[k];
    const Eigen::Vector2d& to = outline[(k + 1) % outline.size()];
    const bool crosses = (from.y() <= point.y()) != (to.y() <= point.y());
    if (crosses && from.x() + (point.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x()) <=
                       point.x()) {
      within = !within;
    }
  }
  return within;
}

} // namespace

const Camera* cameraOf(const TrackSnapshot& snapshot, int camera) {
  const auto index = static_cast<std::size_t>(camera);
  const bool known = snapshot.rig && camera >= 0 && index < snapshot.rig->size();
  return known ? &(*snapshot.rig)[index] : nullptr;
}

TrackingState trackingState(TargetStatus status) {
  switch (status) {
  case TargetStatus::Held:
    return TrackingState::Held;
  case TargetStatus::Ambiguous:
    return TrackingState::Ambiguous;
  case TargetStatus::Lost:
    return TrackingState::Lost;
  case TargetStatus::Gone:
    return TrackingState::Gone;
  case TargetStatus::Searching:
    break;
  }
  return TrackingState::Searching;
}

TrackingState trackingState(const TargetSnapshot& target) {
  const TrackingState state = trackingState(target.status);
  return std::visit(
      Overloaded{[state](const SphereEstimate&) { return state; },
                 [state](const BoxEstimate&) {
                   return state == TrackingState::Searching ? TrackingState::Hidden : state;
                 },
                 [state](const PersonEstimate&) { return state; },
                 [&target](const AbsentEstimate&) { return target.stateWhileAbsent; }},
      target.estimate);
}

namespace {

/// Whether a camera has something to say of a target: a box is followed in the camera of the box
/// only.
bool isShownIn(const TargetSnapshot& target, int camera) {
  const auto& given = target.target.box;
  return std::visit(Overloaded{[](const SphereEstimate&) { return true; },
                               [camera](const BoxEstimate& box) { return box.camera == camera; },
                               [](const PersonEstimate&) { return true; },
                               [camera, &given](const AbsentEstimate&) {
                                 return given && given->camera == camera;
                               }},
                    target.estimate);
}

TrackingState stateOfPeople(const TrackSnapshot& snapshot) {
  if (std::ranges::any_of(snapshot.peopleCameras,
                          [](const auto& camera) { return camera.learningProgress < 1.0; })) {
    return TrackingState::Learning;
  }
  TrackingState state = TrackingState::Nobody;
  for (const TargetSnapshot& target : snapshot.targets) {
    if (target.status == TargetStatus::Searching) {
      return TrackingState::Searching;
    }
    state = target.status == TargetStatus::Held ? TrackingState::Held : state;
  }
  return state;
}

/// Of the targets that count; without any of them there is no box.
template <class Counts>
TrackingState worstState(const TrackSnapshot& snapshot, const Counts& counts) {
  if (!snapshot.frames) {
    return TrackingState::NoImages;
  }
  const bool findsTargets = snapshot.family.findsTargets();
  if (snapshot.targets.empty() && !findsTargets) {
    return TrackingState::NoTarget;
  }
  if (snapshot.isPast && !snapshot.isTracked) {
    return TrackingState::NotTracked;
  }
  if (findsTargets) {
    return stateOfPeople(snapshot);
  }
  for (const TrackingState state :
       {TrackingState::Lost, TrackingState::Searching, TrackingState::Ambiguous,
        TrackingState::Hidden, TrackingState::Held}) {
    if (std::ranges::any_of(snapshot.targets, [&](const TargetSnapshot& target) {
          return counts(target) && trackingState(target) == state;
        })) {
      return state;
    }
  }
  return TrackingState::NoBox;
}

} // namespace

TrackingState trackingState(const TrackSnapshot& snapshot) {
  return worstState(snapshot, [](const TargetSnapshot&) { return true; });
}

TrackingState trackingState(const TrackSnapshot& snapshot, int camera) {
  return worstState(snapshot,
                    [camera](const TargetSnapshot& target) { return isShownIn(target, camera); });
}

const TargetSnapshot* targetToExplain(const TrackSnapshot& snapshot, int preferred) {
  const auto& targets = snapshot.targets;
  if (targets.empty()) {
    return nullptr;
  }
  if (preferred >= 0 && preferred < static_cast<int>(targets.size())) {
    return &targets[static_cast<std::size_t>(preferred)];
  }
  const auto lost = std::ranges::find_if(targets, [](const auto& target) {
    return target.status != TargetStatus::Held && target.status != TargetStatus::Gone;
  });
  const auto held = std::ranges::find(targets, TargetStatus::Held, &TargetSnapshot::status);
  return lost != targets.end() ? &*lost : held != targets.end() ? &*held : &targets.front();
}

const TargetSnapshot* trackedTargetInView(const TrackSnapshot& snapshot, int camera) {
  const Camera* its = cameraOf(snapshot, camera);
  if (its == nullptr) {
    return nullptr;
  }
  const Projector projector(*its);
  const auto isInView = [&](const TargetSnapshot& target) {
    if (target.status != TargetStatus::Held && target.status != TargetStatus::Ambiguous) {
      return false;
    }
    const auto isInImage = [&] {
      const auto position = positionOf(target.estimate);
      const auto pixel = position ? projector.project(position->mean) : std::nullopt;
      return pixel && pixel->x() >= 0.0 && pixel->x() <= its->intrinsics.width &&
             pixel->y() >= 0.0 && pixel->y() <= its->intrinsics.height;
    };
    return std::visit(Overloaded{[&](const SphereEstimate&) { return isInImage(); },
                                 [camera](const BoxEstimate& box) { return box.camera == camera; },
                                 [&](const PersonEstimate&) { return isInImage(); },
                                 [](const AbsentEstimate&) { return false; }},
                      target.estimate);
  };
  const auto found = std::ranges::find_if(snapshot.targets, isInView);
  return found == snapshot.targets.end() ? nullptr : &*found;
}

std::vector<PersonInSnapshot> peopleIn(const TrackSnapshot& snapshot) {
  std::vector<PersonInSnapshot> people;
  for (std::size_t k = 0; k < snapshot.targets.size(); ++k) {
    const TargetSnapshot& target = snapshot.targets[k];
    std::visit(Overloaded{[](const SphereEstimate&) {}, [](const BoxEstimate&) {},
                          [&](const PersonEstimate& person) {
                            people.push_back({k, &target, &person});
                          },
                          [](const AbsentEstimate&) {}},
               target.estimate);
  }
  return people;
}

std::optional<Eigen::Vector2d> pixelOf(const TrackSnapshot& snapshot, int camera,
                                       const Eigen::Vector3d& position) {
  const Camera* its = cameraOf(snapshot, camera);
  return its != nullptr ? Projector(*its).project(position) : std::nullopt;
}

std::optional<Gaussian3> positionEstimate(const TrackSnapshot& snapshot, int target) {
  const auto index = static_cast<std::size_t>(target);
  if (target < 0 || index >= snapshot.targets.size()) {
    return std::nullopt;
  }
  const TrackEstimate& estimate = snapshot.targets[index].estimate;
  return particleCountOf(estimate) > 0 ? positionOf(estimate) : std::nullopt;
}

int targetIndexNear(const TrackSnapshot& snapshot, int count, int camera,
                    const Eigen::Vector2d& pixel, double reach) {
  int nearest = -1;
  double least = reach;
  for (int target = 0; target < count; ++target) {
    const auto belief = positionEstimate(snapshot, target);
    if (belief && !snapshot.targets[static_cast<std::size_t>(target)].target.isShown) {
      continue;
    }
    const auto there = belief ? pixelOf(snapshot, camera, belief->mean) : std::nullopt;
    if (const double distance = there ? (*there - pixel).norm() : 0.0; there && distance <= least) {
      least = distance;
      nearest = target;
    }
  }
  return nearest;
}

const Error* noticeOf(const TrackSnapshot& snapshot, int camera) {
  const Camera* its = cameraOf(snapshot, camera);
  if (its == nullptr) {
    return nullptr;
  }
  const auto found =
      std::ranges::find(snapshot.notices, capture::quotedCameraName(its->name), &Error::field);
  return found != snapshot.notices.end() ? &*found : nullptr;
}

int personIndexAt(const TrackSnapshot& snapshot, int camera, const Eigen::Vector2d& pixel) {
  const Camera* its = cameraOf(snapshot, camera);
  if (its == nullptr) {
    return -1;
  }
  const Projector projector(*its);
  int found = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (const PersonInSnapshot& person : peopleIn(snapshot)) {
    const auto& shape = person.target->shape;
    const double distance = (person.estimate->position - its->center()).norm();
    if (shape && distance < nearest && isWithin(projectedHull(projector, shape->hull), pixel)) {
      nearest = distance;
      found = static_cast<int>(person.targetIndex);
    }
  }
  return found;
}

} // namespace dewpoint::session

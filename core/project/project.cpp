// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include "core/project/project_rig.h"
#include "core/tracking/start_parameters.h"

#include <algorithm>

namespace dewpoint::project {
namespace {

/// Removes what belongs to a removed camera; what belongs to later cameras follows them.
template <class Item> void forgetCamera(std::vector<Item>& items, int removed) {
  std::erase_if(items, [&](const Item& one) { return one.camera == removed; });
  for (Item& one : items) {
    one.camera -= one.camera > removed ? 1 : 0;
  }
}

} // namespace

ParameterValues effectiveParameters(const Project& project) {
  return tracking::effectiveParameters(project.parameters, rigOf(project),
                                       project.volumeOfInterest);
}

void addPersonCorrection(Project& project, const PersonCorrection& person) {
  const auto found = std::ranges::upper_bound(project.personCorrections, person.frame, {},
                                              &PersonCorrection::frame);
  project.personCorrections.insert(found, person);
}

void addCorrection(Project& project, const PositionCorrection& correction) {
  auto& all = project.corrections;
  if (!correction.trackedFrom) {
    std::erase_if(all, [&](const PositionCorrection& other) {
      return other.target == correction.target && other.trackedFrom &&
             (*other.trackedFrom == correction.frame ||
              (other.frame < correction.frame && correction.frame < *other.trackedFrom));
    });
  }
  const auto former = std::ranges::find_if(all, [&](const PositionCorrection& other) {
    return other.frame == correction.frame && other.target == correction.target;
  });
  if (former != all.end()) {
    *former = correction;
  } else {
    all.insert(std::ranges::upper_bound(all, correction.frame, {}, &PositionCorrection::frame),
               correction);
  }
}

void removeCorrection(Project& project, std::int64_t frame, int target) {
  std::erase_if(project.corrections, [&](const PositionCorrection& one) {
    return one.target == target && (one.frame == frame || one.trackedFrom == frame);
  });
}

void removeTarget(Project& project, std::size_t index) {
  const int removed = static_cast<int>(index);
  project.targets.erase(project.targets.begin() + removed);
  std::erase_if(project.corrections,
                [&](const PositionCorrection& one) { return one.target == removed; });
  for (PositionCorrection& correction : project.corrections) {
    correction.target -= correction.target > removed ? 1 : 0;
  }
}

void removeCamera(Project& project, std::size_t index) {
  const int removed = static_cast<int>(index);
  project.cameras.erase(project.cameras.begin() + removed);
  for (MeasuredPoint& point : project.measuredPoints) {
    forgetCamera(point.clicks, removed);
  }
  for (PositionCorrection& correction : project.corrections) {
    forgetCamera(correction.clicks, removed);
  }
  for (Target& target : project.targets) {
    forgetCamera(target.samples, removed);
    if (target.box && target.box->camera == removed) {
      target.box.reset();
    } else if (target.box && target.box->camera > removed) {
      --target.box->camera;
    }
  }
  std::erase_if(project.personCorrections, [&](const PersonCorrection& person) {
    return person.click && person.click->camera == removed;
  });
  for (PersonCorrection& person : project.personCorrections) {
    if (person.click && person.click->camera > removed) {
      --person.click->camera;
    }
  }
}

} // namespace dewpoint::project

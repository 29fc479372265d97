// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include "core/project/project_rig.h"
#include "core/tracking/start_parameters.h"

#include <algorithm>

namespace dewpoint::project {

ParameterValues parametersInUse(const Project& project) {
  return tracking::parametersInUse(project.parameters, rigOf(project), project.volumeOfInterest);
}

void addPerson(Project& project, const PersonCorrection& person) {
  const auto found =
      std::ranges::upper_bound(project.people, person.frame, {}, &PersonCorrection::frame);
  project.people.insert(found, person);
}

} // namespace dewpoint::project

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include <algorithm>

namespace dewpoint::project {

void addPerson(Project& project, const PersonCorrection& person) {
  const auto found =
      std::ranges::upper_bound(project.people, person.frame, {}, &PersonCorrection::frame);
  project.people.insert(found, person);
}

} // namespace dewpoint::project

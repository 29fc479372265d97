// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/default_parameters.h"

#include "core/project/project_rig.h"
#include "core/tracking/start_parameters.h"

#include <algorithm>
#include <cassert>

namespace dewpoint::setup {

ParameterValues defaultParameters(const Project& project) {
  return tracking::effectiveParameters(ParameterValues(project.parameters.declarations()),
                                       rigOf(project), project.volumeOfInterest);
}

bool isChanged(const ParameterValues& used, const ParameterValues& defaults,
               const ParameterDeclaration& declaration) {
  const double value = used.at(declaration.key);
  return value != defaults.at(declaration.key) && value != declaration.defaultValue;
}

void resetParameter(Project& project, std::string_view key) {
  const auto declarations = project.parameters.declarations();
  const auto declaration = std::ranges::find(declarations, key, &ParameterDeclaration::key);
  assert(declaration != declarations.end());
  const ParameterValues defaults = defaultParameters(project);
  if (!declaration->isDerivedFromCameras) {
    (void)project.parameters.set(key, defaults.at(key));
    return;
  }
  ParameterValues parameters = effectiveParameters(project);
  (void)parameters.set(key, defaults.at(key));
  const bool isAllAsSeen = std::ranges::all_of(declarations, [&](const ParameterDeclaration& one) {
    return !one.isDerivedFromCameras || parameters.at(one.key) == defaults.at(one.key);
  });
  isAllAsSeen ? parameters.resetDerivableValues() : parameters.markAllAsGiven();
  project.parameters = parameters;
}

void resetParameters(Project& project) {
  const ParameterValues used = effectiveParameters(project);
  const ParameterValues defaults = defaultParameters(project);
  for (const ParameterDeclaration& declaration : used.declarations()) {
    if (isChanged(used, defaults, declaration)) {
      resetParameter(project, declaration.key);
    }
  }
}

} // namespace dewpoint::setup

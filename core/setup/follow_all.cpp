// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/follow_all.h"

#include <algorithm>
#include <utility>

namespace dewpoint::setup {

int missingTargetCount(const Project& project, std::size_t target,
                       const ColorAssessment& assessment) {
  if (assessment.suggestion != ColorSuggestion::FollowAll || target >= project.targets.size()) {
    return 0;
  }
  const auto same =
      std::ranges::count(project.targets, project.targets[target].colors(), &Target::colors);
  return std::max(0, assessment.similarObjectCount - static_cast<int>(same));
}

void addTargetCopies(Project& project, std::size_t target, int count,
                     const std::function<std::string(const Project&)>& nameOf) {
  for (int k = 0; k < count; ++k) {
    Target another = project.targets.at(target);
    another.name = nameOf(project);
    another.samples.clear();
    project.targets.push_back(std::move(another));
  }
}

std::string unusedTargetName(const Project& project,
                             const std::function<std::string(std::size_t)>& nameOf) {
  std::size_t number = project.targets.size() + 1;
  while (std::ranges::find(project.targets, nameOf(number), &Target::name) !=
         project.targets.end()) {
    ++number;
  }
  return nameOf(number);
}

} // namespace dewpoint::setup

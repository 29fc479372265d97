// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/fresh_target.h"

#include "core/project/project.h"
#include "ui/color/color_learner.h"

#include <algorithm>

namespace dewpoint::ui {

std::string freshTargetName(const Project& project) {
  for (std::size_t number = project.targets.size() + 1;; ++number) {
    const std::string name = ColorLearner::tr("target %1").arg(number).toStdString();
    const auto taken = [&](const Target& target) { return target.name == name; };
    if (std::ranges::none_of(project.targets, taken)) {
      return name;
    }
  }
}

} // namespace dewpoint::ui

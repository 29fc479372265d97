// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/fresh_target.h"

#include "core/setup/follow_all.h"
#include "ui/color/color_learner.h"

#include <cstddef>

namespace dewpoint::ui {

std::string newTargetName(const Project& project) {
  return setup::unusedTargetName(project, [](std::size_t number) {
    return ColorLearner::tr("target %1").arg(number).toStdString();
  });
}

} // namespace dewpoint::ui

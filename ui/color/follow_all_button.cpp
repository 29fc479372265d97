// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/follow_all_button.h"

#include "core/color/color_learning.h"
#include "core/project/project.h"
#include "ui/color/fresh_target.h"
#include "ui/document/document.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace dewpoint::ui {

FollowAllButton::FollowAllButton(Document& document, QWidget* parent)
    : QPushButton(parent), document_(document) {
  setObjectName(QStringLiteral("colorFollowAll"));
  hide();
  connect(this, &QPushButton::clicked, this, &FollowAllButton::follow);
}

void FollowAllButton::offer(const ColorAssessment* assessment, int target) {
  const auto& targets = document_.project().targets;
  target_ = target;
  missing_ = 0;
  if (assessment != nullptr && assessment->suggestion == Suggestion::FollowAll && target >= 0 &&
      target < static_cast<int>(targets.size())) {
    const ColorRanges colors = targets[static_cast<std::size_t>(target)].colors();
    const auto same = std::ranges::count_if(
        targets, [&](const Target& other) { return other.colors() == colors; });
    missing_ = std::max(0, assessment->alike - static_cast<int>(same));
    setText(tr("Follow all %n of them", nullptr, assessment->alike));
    setToolTip(tr("Add a target of the same color and size for each of the others"));
  }
  setVisible(missing_ > 0);
}

void FollowAllButton::follow() {
  const int count = missing_;
  (void)document_.edit(tr("Follow all of one color"), [&](Project& project) {
    for (int k = 0; k < count; ++k) {
      Target another = project.targets.at(static_cast<std::size_t>(target_));
      another.name = freshTargetName(project);
      another.samples.clear();
      project.targets.push_back(std::move(another));
    }
  });
}

} // namespace dewpoint::ui

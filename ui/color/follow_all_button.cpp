// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/follow_all_button.h"

#include "core/setup/follow_all.h"
#include "ui/color/fresh_target.h"
#include "ui/document/document.h"

#include <cstddef>

namespace dewpoint::ui {

FollowAllButton::FollowAllButton(Document& document, QWidget* parent)
    : QPushButton(parent), document_(document) {
  setObjectName(QStringLiteral("colorFollowAll"));
  hide();
  connect(this, &QPushButton::clicked, this, &FollowAllButton::follow);
}

void FollowAllButton::offer(const ColorAssessment* assessment, int target) {
  target_ = target;
  missing_ = assessment != nullptr && target >= 0
                 ? setup::missingTargetCount(document_.project(), static_cast<std::size_t>(target),
                                             *assessment)
                 : 0;
  if (missing_ > 0) {
    setText(tr("Follow all %n objects", nullptr, assessment->similarObjectCount));
    setToolTip(tr("Add a target for each of the other objects of this color and size"));
  }
  setVisible(missing_ > 0);
}

void FollowAllButton::follow() {
  const int count = missing_;
  (void)document_.edit(tr("Follow all objects of one color"), [&](Project& project) {
    setup::addTargetCopies(project, static_cast<std::size_t>(target_), count, newTargetName);
  });
}

} // namespace dewpoint::ui

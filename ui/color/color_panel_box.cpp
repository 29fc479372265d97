// SPDX-License-Identifier: GPL-3.0-or-later
// The panel while the method follows boxes: they are pointed at in place of a color.
#include "core/project/project.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/color/color_panel.h"
#include "ui/color/color_picker.h"
#include "ui/document/document.h"

#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include <algorithm>

namespace dewpoint::ui {

bool ColorPanel::takesBoxes() const {
  return methodFamily(document_.project().method).targets == TargetsFrom::Box;
}

bool ColorPanel::mustPoint() const {
  if (methodFamily(document_.project().method).findsTargets()) {
    return false; // they are found by themselves
  }
  const auto& targets = document_.project().targets;
  const auto hasBox = [](const Target& target) { return target.box.has_value(); };
  return takesBoxes() ? std::ranges::none_of(targets, hasBox) : targets.empty();
}

/// Methods for boxes learn all they need from one.
void ColorPanel::showBox() {
  const Project& project = document_.project();
  const auto index = static_cast<std::size_t>(std::max(0, target_));
  const bool has = target_ >= 0 && index < project.targets.size() && project.targets[index].box;
  judged_ = false;
  picker_->setEnabled(false);
  for (QWidget* of : {static_cast<QWidget*>(samplesTitle_), static_cast<QWidget*>(samples_),
                      static_cast<QWidget*>(remove_)}) {
    of->hide();
  }
  clearRegions();
  if (has) {
    const TargetBox& box = *project.targets[index].box;
    const auto camera = static_cast<std::size_t>(box.camera);
    verdict_->setText(
        tr("Followed from its box in %1, frame %2: %3 × %4 px. This method needs no color; press "
           "Box and click the thing for another box.")
            .arg(camera < project.cameras.size()
                     ? QString::fromStdString(project.cameras[camera].camera.name)
                     : QString::number(box.camera + 1))
            .arg(box.frame + 1)
            .arg(qRound(box.box.width))
            .arg(qRound(box.box.height)));
  } else {
    verdict_->setText(tr("Click the thing or drag a box around it in any camera view."));
  }
  setPicking(picking_);
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/planner/plan_page.h"

#include "ui/calibration/planner/planner_form.h"
#include "ui/calibration/planner/rig_planner.h"
#include "ui/calibration/planner/uncertainty_map_form.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/page_title.h"

#include <QLabel>
#include <QVBoxLayout>

namespace dewpoint::ui {

PlanPage::PlanPage(RigPlanner& plan, QWidget* parent)
    : QWidget(parent), guide_(new QLabel(this)), mapTitle_(makePageTitle(this)),
      cameraTitle_(makePageTitle(this)), note_(new QLabel(this)) {
  setObjectName(QStringLiteral("planPage"));
  guide_->setWordWrap(true);
  note_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(guide_);
  column->addWidget(mapTitle_);
  column->addWidget(new UncertaintyMapForm(plan, this));
  column->addWidget(cameraTitle_);
  column->addWidget(new PlannerForm(plan, this));
  column->addWidget(note_);
  column->addStretch(1);
  onRetranslate(this, [this] { retranslateUi(); });
}

void PlanPage::retranslateUi() {
  guide_->setText(tr("See how accurately these cameras will measure, and where another camera "
                     "would help. Drag a camera in the bird's-eye view to update the map."));
  mapTitle_->setText(tr("Map of expected errors"));
  cameraTitle_->setText(tr("Planned cameras"));
  note_->setText(tr("Planned cameras are not saved with the project and take no part in the run. "
                    "The map does not account for objects that block the view."));
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_calibration_page.h"

#include "ui/calibration/wand/touched_instant_list.h"
#include "ui/calibration/wand/wand_calibrator.h"
#include "ui/calibration/wand/wand_form.h"
#include "ui/calibration/wand/wand_outcome.h"
#include "ui/calibration/wand/wand_waving.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/page_title.h"

#include <QLabel>
#include <QVBoxLayout>

namespace dewpoint::ui {

WandCalibrationPage::WandCalibrationPage(WandCalibrator& calibrator, QWidget* parent)
    : QWidget(parent), calibrator_(calibrator), guide_(new QLabel(this)),
      instantsTitle_(makePageTitle(this)), wavingTitle_(makePageTitle(this)),
      waving_(new WandWaving(calibrator, this)), outcomeTitle_(makePageTitle(this)) {
  setObjectName(QStringLiteral("wandPage"));
  guide_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(guide_);
  column->addWidget(new WandForm(calibrator, this));
  column->addWidget(wavingTitle_);
  column->addWidget(waving_);
  column->addWidget(instantsTitle_);
  column->addWidget(new TouchedInstantList(calibrator, this));
  column->addWidget(outcomeTitle_);
  column->addWidget(new WandOutcome(calibrator, this));
  column->addStretch(1);
  connect(&calibrator_, &WandCalibrator::changed, this, &WandCalibrationPage::retranslateUi);
  onRetranslate(this, [this] { retranslateUi(); });
}

void WandCalibrationPage::retranslateUi() {
  guide_->setText(
      calibrator_.usesLiveCameras()
          ? tr("Align the cameras by hand until they are roughly right. Then wave the ball, or a "
               "wand with two balls, through the whole volume, and press Refine cameras.")
          : tr("Align the cameras by hand until they are roughly right. Then refine "
               "them with a recording in which you wave a ball, or a wand with two "
               "balls, through the whole volume."));
  instantsTitle_->setText(tr("Floor"));
  wavingTitle_->setText(tr("Wand"));
  outcomeTitle_->setText(tr("Refine"));
  wavingTitle_->setVisible(calibrator_.usesLiveCameras());
  waving_->setVisible(calibrator_.usesLiveCameras());
}

} // namespace dewpoint::ui

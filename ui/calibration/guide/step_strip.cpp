// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/guide/step_strip.h"

#include "ui/calibration/guide/calibration_guide.h"
#include "ui/calibration/guide/guide_text.h"
#include "ui/text/retranslation.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace dewpoint::ui {

namespace {

/// A tick or a circle, and the number if there is one.
QString glance(const StepProgress& progress, const QString& number) {
  if (!progress.isDone()) {
    return number.isEmpty() ? QStringLiteral("○") : number;
  }
  return number.isEmpty() ? QStringLiteral("✓") : QStringLiteral("✓ ") + number;
}

} // namespace

StepStrip::StepStrip(CalibrationGuide& guide, QWidget* parent)
    : QWidget(parent), guide_(guide), row_(new QHBoxLayout(this)) {
  setObjectName(QStringLiteral("guideStrip"));
  row_->setContentsMargins(8, 4, 8, 4);
  row_->setSpacing(2);
  connect(&guide_, &CalibrationGuide::changed, this, &StepStrip::refresh);
  onRetranslate(this, [this] { refresh(); });
}

void StepStrip::setCount(int count) {
  while (static_cast<int>(buttons_.size()) > count) {
    delete buttons_.back();
    buttons_.pop_back();
  }
  while (static_cast<int>(buttons_.size()) < count) {
    const int index = static_cast<int>(buttons_.size());
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("guideStep%1").arg(index));
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setMinimumWidth(0);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // all are of one width
    connect(button, &QToolButton::clicked, this, [this, index] {
      guide_.goToStep(index);
      refresh(); // it stays checked
      Q_EMIT guide_.openRequested(guide_.steps().at(static_cast<std::size_t>(index)));
    });
    row_->addWidget(button);
    buttons_.push_back(button);
  }
}

void StepStrip::refresh() {
  const auto steps = guide_.steps();
  // Not as soon as a way is known: the pages must not move while a result comes, and nobody who
  // works without the guide has to wonder about its steps.
  setVisible(guide_.isInUse() && !steps.empty());
  setCount(static_cast<int>(steps.size()));
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const StepText text = stepText(steps[k]);
    const StepProgress progress = guide_.progressOf(steps[k]);
    const QString number = progressNumberText(steps[k], progress);
    QToolButton* button = buttons_[k];
    button->setText(glance(progress, number) + QLatin1Char('\n') + text.name);
    button->setChecked(static_cast<int>(k) == guide_.currentStep());
    button->setAccessibleName(tr("Step %1: %2").arg(k + 1).arg(text.title));
    button->setToolTip(
        tr("Step %1: %2. %3").arg(k + 1).arg(text.title, progressText(steps[k], progress)));
  }
}

} // namespace dewpoint::ui

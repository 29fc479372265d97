// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/guide/calibration_guide.h"

#include "ui/document/document.h"

#include <algorithm>

namespace dewpoint::ui {

CalibrationGuide::CalibrationGuide(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document_, &Document::changed, this, &CalibrationGuide::refresh);
  connect(&document_, &Document::projectReplaced, this, &CalibrationGuide::restart);
  restart();
}

void CalibrationGuide::restart() {
  status_ = calibrationStatus(document_.project());
  procedure_ = procedureInUse(status_);
  isInUse_ = false;
  current_ = 0;
  if (procedure_) {
    adoptProcedure(*procedure_);
  } else {
    Q_EMIT changed();
  }
}

void CalibrationGuide::refresh() {
  status_ = calibrationStatus(document_.project());
  if (const auto taken = procedureInUse(status_); taken && !procedure_) {
    adoptProcedure(*taken); // somebody who knows the pages has begun without the guide
  } else {
    Q_EMIT changed();
  }
}

void CalibrationGuide::setProcedure(CalibrationProcedure procedure) {
  isInUse_ = true;
  adoptProcedure(procedure);
}

void CalibrationGuide::markOpened() {
  if (procedure_ && !isInUse_) {
    isInUse_ = true;
    Q_EMIT changed();
  }
}

void CalibrationGuide::adoptProcedure(CalibrationProcedure procedure) {
  procedure_ = procedure;
  const auto& all = stepsOf(procedure);
  const GuideStep next = nextStep(procedure, document_.project(), status_);
  current_ = static_cast<int>(std::ranges::find(all, next) - all.begin());
  Q_EMIT changed();
}

std::vector<GuideStep> CalibrationGuide::steps() const {
  return procedure_ ? stepsOf(*procedure_) : std::vector<GuideStep>();
}

StepProgress CalibrationGuide::progressOf(GuideStep step) const {
  return setup::progressOf(step, document_.project(), status_);
}

void CalibrationGuide::goToStep(int index) {
  const int last = static_cast<int>(steps().size()) - 1;
  const int wanted = std::clamp(index, 0, std::max(0, last));
  if (wanted != current_) {
    current_ = wanted;
    Q_EMIT changed();
  }
}

} // namespace dewpoint::ui

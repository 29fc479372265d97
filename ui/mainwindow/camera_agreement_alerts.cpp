// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/camera_agreement_alerts.h"

#include "core/session/watch/camera_repair.h"
#include "ui/text/camera_agreement_text.h"
#include "ui/text/reason_text.h"
#include "ui/widgets/message_bar.h"

#include <algorithm>

namespace dewpoint::ui {

CameraAgreementAlerts::CameraAgreementAlerts(MessageBar& bar, QObject* parent)
    : QObject(parent), bar_(bar) {}

void CameraAgreementAlerts::setSnapshot(const TrackSnapshotPtr& snapshot) {
  const std::vector<CameraDisagreement> none;
  const auto& found = snapshot ? snapshot->disagreements : none;
  const auto isAmong = [](const auto& all, const CameraDisagreement& one) {
    return std::ranges::any_of(all, [&](const auto& other) { return other.isSameAs(one); });
  };
  const bool isGone =
      !shown_.empty() && !isAmong(found, shown_.back()); // what the bar may still say
  std::erase_if(shown_, [&](const auto& one) { return !isAmong(found, one); });
  if (isGone) {
    withdraw();
  }
  const auto next = std::ranges::find_if(
      found, [&](const CameraDisagreement& one) { return !isAmong(shown_, one); });
  const bool isOpen = bar_.isQuestionOpen(text_);
  if (next != found.end() && !isOpen && !suppressed_) {
    shown_.push_back(*next);
    show(*next, cameraNames(*snapshot));
  }
}

void CameraAgreementAlerts::withdraw() {
  if (!text_.isEmpty()) {
    bar_.withdrawQuestion(text_);
  }
  text_.clear();
}

void CameraAgreementAlerts::show(const CameraDisagreement& found, const QStringList& names) {
  std::vector<MessageBar::Answer> answers;
  for (std::size_t choice = 0; choice < repairChoiceCount(found); ++choice) {
    answers.emplace_back(rigCorrectionText(found, choice, names),
                         [this, found, choice] { Q_EMIT rigCorrectionRequested(found, choice); });
  }
  if (answers.empty()) {
    for (const std::size_t camera : found.cameras) {
      answers.emplace_back(
          tr("Calibrate %1…").arg(names.value(static_cast<int>(camera))),
          [this, camera] { Q_EMIT calibrationRequested(static_cast<int>(camera)); });
    }
  }
  bar_.showLastingQuestion(disagreementText(found, names), answers);
  text_ = bar_.text();
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/delay_estimate.h"

#include "core/base/units.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <cmath>

namespace dewpoint::ui {

DelayEstimate::DelayEstimate(QWidget* parent)
    : QWidget(parent), text_(new QLabel(this)), keep_(new QPushButton(this)) {
  setObjectName(QStringLiteral("cameraDelayEstimate"));
  keep_->setObjectName(QStringLiteral("cameraKeepDelay"));
  text_->setWordWrap(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addWidget(text_, 1);
  row->addWidget(keep_);
  connect(keep_, &QPushButton::clicked, this, [this] {
    if (estimate_) {
      Q_EMIT delayAccepted(estimate_->delaySeconds);
    }
  });
  onRetranslate(this, [this] { retranslateUi(); });
}

void DelayEstimate::setEstimate(const std::optional<ClockEstimate>& estimate,
                                const QString& firstCamera) {
  estimate_ = estimate && estimate->delaySigma > 0.0 ? estimate : std::nullopt;
  firstCamera_ = firstCamera;
  refresh();
}

void DelayEstimate::setEditable(bool editable) {
  keep_->setEnabled(editable);
}

void DelayEstimate::retranslateUi() {
  keep_->setText(tr("Keep"));
  keep_->setToolTip(tr("Add the estimated delay to the delay of this camera in the project"));
  text_->setToolTip(
      tr("This delay is estimated from the motion of the targets, and corrected while tracking. To "
         "switch this off, set the parameter “Delay spread” to 0"));
  refresh();
}

void DelayEstimate::refresh() {
  setVisible(estimate_.has_value());
  if (!estimate_) {
    return;
  }
  const QString delay = millisecondsText(inMilliseconds(std::abs(estimate_->delaySeconds)));
  const QString sigma = millisecondsText(inMilliseconds(estimate_->delaySigma));
  const QString text = estimate_->delaySeconds >= 0.0 ? tr("Estimate: %1 later than %2, ±%3")
                                                      : tr("Estimate: %1 earlier than %2, ±%3");
  text_->setText(text.arg(delay, firstCamera_, sigma));
}

} // namespace dewpoint::ui

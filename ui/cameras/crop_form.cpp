// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/crop_form.h"

#include "core/setup/calibration/calibrated_project.h"
#include "ui/style/spacing.h"
#include "ui/text/retranslation.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <chrono>

namespace dewpoint::ui {

namespace {

/// After the last step. Chosen: longer than between two clicks on an arrow.
constexpr std::chrono::milliseconds kSettleTime(500);
constexpr std::array<const char*, 4> kFieldNames{"cropLeft", "cropTop", "cropRight", "cropBottom"};

} // namespace

CropForm::CropForm(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kSpacing);
  settled_.setSingleShot(true);
  settled_.setInterval(kSettleTime);
  connect(&settled_, &QTimer::timeout, this, &CropForm::report);
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    auto* field = new QSpinBox(this);
    field->setObjectName(QLatin1String(kFieldNames[k]));
    field->setKeyboardTracking(false);
    connect(field, &QSpinBox::valueChanged, &settled_, qOverload<>(&QTimer::start));
    connect(field, &QSpinBox::editingFinished, this, &CropForm::report);
    row->addWidget(field, 1);
    fields_[k] = field;
  }
  onRetranslate(this, [this] {
    const QStringList names{tr("left"), tr("top"), tr("right"), tr("bottom")};
    for (std::size_t k = 0; k < fields_.size(); ++k) {
      const QString& name = names[static_cast<qsizetype>(k)];
      fields_[k]->setPrefix(name + QLatin1Char(' '));
      fields_[k]->setAccessibleName(name);
      fields_[k]->setToolTip(tr("Pixels to cut off at this edge, after rotation and mirroring. The "
                                "calibration is converted. Color samples and boxes in the part "
                                "that is cut off are removed; Undo brings them back"));
    }
  });
}

ImageMargins CropForm::entered() const {
  return {fields_[0]->value(), fields_[1]->value(), fields_[2]->value(), fields_[3]->value()};
}

void CropForm::setMargins(int camera, const ImageMargins& margins, int width, int height) {
  if (camera == camera_ && margins == shown_ && settled_.isActive()) {
    return;
  }
  settled_.stop();
  camera_ = camera;
  shown_ = margins;
  const std::array<int, 4> values{margins.left, margins.top, margins.right, margins.bottom};
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const QSignalBlocker silent(fields_[k]);
    const int side = k % 2 == 0 ? width : height;
    const int opposite = values[(k + 2) % fields_.size()];
    fields_[k]->setRange(0, std::max(values[k], side - opposite - kSmallestCrop));
    fields_[k]->setValue(values[k]);
  }
}

void CropForm::report() {
  settled_.stop();
  if (camera_ >= 0 && entered() != shown_) {
    shown_ = entered();
    Q_EMIT changed(camera_, shown_);
  }
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_form.h"

#include "core/base/angle.h"
#include "core/base/units.h"
#include "core/project/project.h"
#include "ui/calibration/wand/wand_calibrator.h"
#include "ui/document/target_list_model.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>

namespace dewpoint::ui {
namespace {

QCheckBox* makeCheck(const char* name, QWidget* parent) {
  auto* check = new QCheckBox(parent);
  check->setObjectName(QLatin1String(name));
  return check;
}

void showChoice(QComboBox& box, int index) {
  const QSignalBlocker quiet(box);
  box.setCurrentIndex(index);
}

} // namespace

WandForm::WandForm(WandCalibrator& calibrator, QWidget* parent)
    : QWidget(parent), calibrator_(calibrator) {
  setObjectName(QStringLiteral("wandFields"));
  createWidgets();
  connectFields();
  onRetranslate(this, [this] { retranslateUi(); });
}

void WandForm::createWidgets() {
  kindLabel_ = new QLabel(this);
  kind_ = makeChoiceField("wandKind", this);
  ballLabel_ = new QLabel(this);
  ball_ = makeChoiceField("wandBall", this);
  otherLabel_ = new QLabel(this);
  other_ = makeChoiceField("wandOther", this);
  ball_->setModel(&calibrator_.targets());
  other_->setModel(&calibrator_.targets());
  lengthLabel_ = new QLabel(this);
  length_ = makeNumberField(QStringLiteral("wandLength"), {0.1, 1e4, 1.0, 2}, this);
  sizeLabel_ = new QLabel(this);
  size_ = makeChoiceField("wandSize", this);
  distanceLabel_ = new QLabel(this);
  distance_ = makeNumberField(QStringLiteral("wandDistance"), {0.1, 1e5, 1.0, 2}, this);
  initialErrorLabel_ = new QLabel(this);
  initialPositionError_ =
      makeNumberField(QStringLiteral("wandRoughPlace"), {0.1, 1e4, 1.0, 1}, this);
  initialRotationError_ =
      makeNumberField(QStringLiteral("wandRoughTurn"), {0.1, 90.0, 1.0, 1}, this);
  offsets_ = makeCheck("wandOffsets", this);
  focal_ = makeCheck("wandFocal", this);
  distortion_ = makeCheck("wandDistortion", this);
  onlyRange_ = makeCheck("wandSpan", this);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  for (int column = 0; column < 3; ++column) {
    grid->setColumnStretch(column, 1);
  }
  const auto row = [&](int at, QLabel* label, QWidget* field) {
    grid->addWidget(label, at, 0);
    grid->addWidget(field, at, 1, 1, 2);
    label->setBuddy(field);
  };
  row(0, kindLabel_, kind_);
  row(1, ballLabel_, ball_);
  row(2, otherLabel_, other_);
  row(3, lengthLabel_, length_);
  row(4, sizeLabel_, size_);
  row(5, distanceLabel_, distance_);
  grid->addWidget(initialErrorLabel_, 6, 0);
  grid->addWidget(initialPositionError_, 6, 1);
  grid->addWidget(initialRotationError_, 6, 2);
  initialErrorLabel_->setBuddy(initialPositionError_);
  int at = 7; // one below the other: some languages need the width
  for (QWidget* check :
       std::initializer_list<QWidget*>{offsets_, focal_, distortion_, onlyRange_}) {
    grid->addWidget(check, at++, 0, 1, 3);
  }
}

void WandForm::connectFields() {
  connect(&calibrator_, &WandCalibrator::changed, this, &WandForm::refresh);
  connect(kind_, &QComboBox::activated, this, [this](int index) {
    edit([=](WandSettings& settings) { settings.usesStick = index == 1; });
  });
  connect(ball_, &QComboBox::activated, this, [this] {
    edit([this](WandSettings& settings) {
      settings.ballTarget = ball_->currentText().toStdString();
    });
  });
  connect(other_, &QComboBox::activated, this, [this] {
    edit([this](WandSettings& settings) {
      settings.secondBallTarget = other_->currentText().toStdString();
    });
  });
  connect(length_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit([=](WandSettings& settings) { settings.stickLength = fromCentimeters(value); });
  });
  connect(size_, &QComboBox::activated, this, [this](int index) {
    edit([=](WandSettings& settings) {
      settings.scaleSource = static_cast<WandScaleSource>(index);
    });
  });
  connect(distance_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit([=](WandSettings& settings) { settings.touchedDistance = fromCentimeters(value); });
  });
  connect(initialPositionError_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit([=](WandSettings& settings) { settings.initialPositionError = fromCentimeters(value); });
  });
  connect(initialRotationError_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit([=](WandSettings& settings) { settings.initialRotationError = value * base::kDegree; });
  });
  const auto check = [this](QCheckBox* box, bool WandSettings::*field) {
    connect(box, &QCheckBox::clicked, this, [this, field](bool checked) {
      edit([=](WandSettings& settings) { settings.*field = checked; });
    });
  };
  check(offsets_, &WandSettings::estimatesTimeOffsets);
  check(focal_, &WandSettings::estimatesFocalLengths);
  check(distortion_, &WandSettings::estimatesDistortion);
  check(onlyRange_, &WandSettings::usesOnlySelectedFrames);
}

void WandForm::edit(const std::function<void(WandSettings&)>& change) {
  WandSettings settings = calibrator_.settings();
  change(settings);
  calibrator_.setSettings(settings);
}

void WandForm::chooseBalls() {
  WandSettings both = calibrator_.settings();
  both.usesStick = true;
  const auto balls = selectedTargets(both, calibrator_.project());
  for (QComboBox* box : {ball_, other_}) {
    const std::size_t end = box == ball_ ? 0 : 1;
    box->setCurrentIndex(end < balls.size() ? box->findText(QString::fromStdString(balls[end]))
                                            : -1);
  }
}

void WandForm::fillSizes() {
  const auto& targets = calibrator_.project().targets;
  const auto balls = selectedTargets(calibrator_.settings(), calibrator_.project());
  const auto ball =
      balls.empty() ? targets.end() : std::ranges::find(targets, balls.front(), &Target::name);
  const QString diameter =
      ball == targets.end() ? tr("the ball's diameter")
                            : tr("the ball's diameter, %1")
                                  .arg(lengthText(2.0 * ball->radius, LengthScale::Centimeters, 1));
  setChoices(*size_, {tr("the current camera positions"), diameter, tr("a known distance")});
}

void WandForm::refresh() {
  const WandSettings& settings = calibrator_.settings();
  chooseBalls();
  fillSizes();
  showChoice(*kind_, settings.usesStick ? 1 : 0);
  showChoice(*size_, static_cast<int>(settings.scaleSource));
  showValue(*length_, inCentimeters(settings.stickLength));
  showValue(*distance_, inCentimeters(settings.touchedDistance));
  showValue(*initialPositionError_, inCentimeters(settings.initialPositionError));
  showValue(*initialRotationError_, inDegrees(settings.initialRotationError));
  offsets_->setChecked(settings.estimatesTimeOffsets);
  focal_->setChecked(settings.estimatesFocalLengths);
  distortion_->setChecked(settings.estimatesDistortion);
  onlyRange_->setChecked(settings.usesOnlySelectedFrames && calibrator_.hasSelectedRange());
  onlyRange_->setEnabled(calibrator_.hasSelectedRange());
  for (QWidget* field :
       std::initializer_list<QWidget*>{otherLabel_, other_, lengthLabel_, length_}) {
    field->setVisible(settings.usesStick);
  }
  sizeLabel_->setVisible(!settings.usesStick);
  size_->setVisible(!settings.usesStick);
  const bool distance = !settings.usesStick && settings.scaleSource == WandScaleSource::Distance;
  distanceLabel_->setVisible(distance);
  distance_->setVisible(distance);
  onlyRange_->setVisible(!calibrator_.usesLiveCameras());
  setEnabled(!calibrator_.isRefining());
}

void WandForm::retranslateUi() {
  const auto name = [](QWidget* field, const QString& text, const QString& tip) {
    field->setAccessibleName(text);
    field->setToolTip(tip);
  };
  const auto check = [](QCheckBox* field, const QString& text, const QString& tip) {
    field->setText(text);
    field->setAccessibleName(text);
    field->setToolTip(tip);
  };
  kindLabel_->setText(tr("Wand"));
  setChoices(*kind_, {tr("one ball"), tr("wand with two balls")});
  name(kind_, tr("Kind of wand"),
       tr("A wand with two balls also gives the scale. This scale is more accurate than one from a "
          "diameter or a distance"));
  ballLabel_->setText(tr("Ball"));
  name(ball_, tr("Ball"), tr("The target that you wave; it is detected by its color"));
  otherLabel_->setText(tr("Second ball"));
  name(other_, tr("Second ball"), tr("The target at the other end of the wand"));
  lengthLabel_->setText(tr("Length"));
  name(length_, tr("Length of the wand"),
       tr("Distance from the center of one ball to the center of the other"));
  length_->setSuffix(tr(" cm"));
  sizeLabel_->setText(tr("Scale from"));
  name(size_, tr("Source of the scale"),
       tr("Images alone cannot show whether a room is large or small. A scale from the diameter of "
          "a ball is accurate to about one percent. A scale from a distance is as accurate as your "
          "measurement"));
  distanceLabel_->setText(tr("Distance"));
  name(distance_, tr("Known distance"),
       tr("Distance between the two positions at which the center of the ball was held"));
  distance_->setSuffix(tr(" cm"));
  initialErrorLabel_->setText(tr("Initial error"));
  name(initialPositionError_, tr("Expected error of the initial positions"),
       tr("Roughly how far each camera may be from its true position"));
  initialPositionError_->setSuffix(tr(" cm"));
  name(initialRotationError_, tr("Expected error of the initial rotations"),
       tr("Roughly how far each camera may be rotated from its true orientation"));
  initialRotationError_->setSuffix(QStringLiteral("°"));
  check(offsets_, tr("Find delays"),
        tr("Also compute the delay of each camera. Use this if the cameras do not take their "
           "images at the same time"));
  check(focal_, tr("Find focal lengths"),
        tr("Also compute the focal length of each camera. Use this for lenses that were never "
           "calibrated, or whose zoom has changed"));
  check(distortion_, tr("Find the distortion k1"),
        tr("Also compute the first distortion coefficient of each lens. For this, the ball must be "
           "seen up to the edges of the images"));
  check(onlyRange_, tr("Only the selected time span"),
        tr("Use only the part of the recording that is selected in the timeline"));
  refresh();
}

} // namespace dewpoint::ui

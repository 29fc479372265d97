// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parameter_row.h"

#include "ui/text/quantity_text.h"
#include "ui/widgets/decimal_field.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr int kSliderSteps = 1000;

int decimalsFor(const ParameterDeclaration& declaration) {
  if (declaration.kind == ParameterKind::Integer || declaration.step <= 0.0) {
    return declaration.kind == ParameterKind::Integer ? 0 : 3;
  }
  return std::clamp(static_cast<int>(std::ceil(-std::log10(declaration.step) - 1e-9)), 0, 6);
}

/// The unit as it stands behind a number; empty where there is none.
QString unitSuffix(const ParameterDeclaration& declaration) {
  return declaration.unit.empty()
             ? QString()
             : QStringLiteral(" ") + QCoreApplication::translate("Unit", declaration.unit.c_str());
}

} // namespace

ParameterRow::ParameterRow(const ParameterDeclaration& declaration, QWidget* parent)
    : QWidget(parent), declaration_(declaration), slider_(new QSlider(Qt::Horizontal, this)),
      box_(new DecimalField(this)) {
  const QString name = QString::fromStdString(declaration.key);
  setObjectName(QStringLiteral("parameter_") + name);
  slider_->setObjectName(QStringLiteral("slider_") + name);
  box_->setObjectName(QStringLiteral("box_") + name);
  auto* label =
      new QLabel(QCoreApplication::translate("Parameter", declaration.label.c_str()), this);
  label->setObjectName(QStringLiteral("label_") + name);
  label->setBuddy(box_);
  label->setWordWrap(true); // long words of some languages must not push the numbers out

  slider_->setRange(0, kSliderSteps);
  slider_->setPageStep(kSliderSteps / 20);
  box_->setDecimals(decimalsFor(declaration));
  box_->setRange(declaration.minimum, declaration.maximum);
  box_->setSingleStep(declaration.step > 0.0 ? declaration.step : 1.0);
  box_->setKeyboardTracking(false);
  box_->setAlignment(Qt::AlignRight);
  box_->setMinimumWidth(112);
  box_->setSuffix(unitSuffix(declaration));
  setToolTip(tooltip());

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->addWidget(label, 0, 0);
  grid->addWidget(box_, 0, 1);
  grid->addWidget(slider_, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);

  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { Q_EMIT valueEdited(fromSlider(position)); });
  connect(box_, &QDoubleSpinBox::valueChanged, this, &ParameterRow::valueEdited);
}

void ParameterRow::setValue(double value) {
  const QSignalBlocker quietSlider(slider_);
  const QSignalBlocker quietBox(box_);
  // A dragged slider stays where the hand holds it, though its value was rounded.
  if (!slider_->isSliderDown()) {
    slider_->setValue(toSlider(value));
  }
  box_->setValue(value);
}

double ParameterRow::fromSlider(int position) const {
  const double part = static_cast<double>(position) / kSliderSteps;
  const ParameterDeclaration& d = declaration_;
  const bool factors = d.logarithmic && d.minimum > 0.0;
  double value = factors ? d.minimum * std::pow(d.maximum / d.minimum, part)
                         : d.minimum + part * (d.maximum - d.minimum);
  if (d.kind == ParameterKind::Integer) {
    value = std::round(value);
  } else {
    const double grid = std::pow(10.0, box_->decimals());
    value = std::round(value * grid) / grid;
  }
  return std::clamp(value, d.minimum, d.maximum);
}

int ParameterRow::toSlider(double value) const {
  const ParameterDeclaration& d = declaration_;
  if (d.maximum <= d.minimum) {
    return 0;
  }
  const bool factors = d.logarithmic && d.minimum > 0.0;
  const double part = factors ? std::log(value / d.minimum) / std::log(d.maximum / d.minimum)
                              : (value - d.minimum) / (d.maximum - d.minimum);
  return static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * kSliderSteps));
}

QString ParameterRow::tooltip() const {
  if (declaration_.fromCameras) {
    return QCoreApplication::translate(
               "ParameterRow", "%1\nFrom %2 to %3%4; what the cameras see unless you change it.")
        .arg(QCoreApplication::translate("Parameter", declaration_.sentence.c_str()),
             declaredText(declaration_.minimum), declaredText(declaration_.maximum),
             unitSuffix(declaration_));
  }
  return QCoreApplication::translate("ParameterRow", "%1\nFrom %2 to %3%4; default %5%4.")
      .arg(QCoreApplication::translate("Parameter", declaration_.sentence.c_str()),
           declaredText(declaration_.minimum), declaredText(declaration_.maximum),
           unitSuffix(declaration_), declaredText(declaration_.defaultValue));
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/control_form.h"

#include "ui/cameras/camera_device_text.h"
#include "ui/style/spacing.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>

#include <algorithm>
#include <limits>

namespace dewpoint::ui {

namespace {

int asInt(std::int64_t value) {
  return static_cast<int>(std::clamp<std::int64_t>(value, std::numeric_limits<int>::min(),
                                                   std::numeric_limits<int>::max()));
}

QString fieldName(const capture::DeviceControl& control) {
  return QStringLiteral("control_") + QString::fromStdString(control.name);
}

bool areAlike(const capture::DeviceControl& one, const capture::DeviceControl& other) {
  return one.name == other.name && one.kind == other.kind && one.minimum == other.minimum &&
         one.maximum == other.maximum && one.step == other.step && one.menuItems == other.menuItems;
}

} // namespace

ControlForm::ControlForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
  setObjectName(QStringLiteral("controlForm"));
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setSpacing(kSpacing);
}

void ControlForm::setControls(const std::vector<capture::DeviceControl>& controls) {
  const bool same = std::ranges::equal(controls, controls_, areAlike);
  if (same && isDragged_) {
    return; // the hand decides
  }
  controls_ = controls;
  if (!same) {
    rebuild();
  }
  showValues();
}

void ControlForm::rebuild() {
  isDragged_ = false;
  while (form_->rowCount() > 0) {
    form_->removeRow(0);
  }
  for (const capture::DeviceControl& control : controls_) {
    QWidget* field = makeField(control);
    field->setObjectName(fieldName(control));
    field->setAccessibleName(controlText(control));
    auto* label = new QLabel(controlText(control), this);
    label->setBuddy(field);
    label->setToolTip(QString::fromStdString(control.label));
    form_->addRow(label, field);
  }
}

QWidget* ControlForm::makeField(const capture::DeviceControl& control) {
  switch (control.kind) {
  case capture::ControlKind::Boolean: {
    auto* box = new QCheckBox(this);
    connect(box, &QCheckBox::clicked, this,
            [this, name = control.name](bool on) { Q_EMIT changed(name, on ? 1 : 0); });
    return box;
  }
  case capture::ControlKind::Menu: {
    auto* box = new QComboBox(this);
    for (const capture::ControlMenuItem& item : control.menuItems) {
      box->addItem(menuItemText(control, item), QVariant::fromValue<qint64>(item.value));
    }
    connect(box, &QComboBox::activated, this, [this, box, name = control.name] {
      Q_EMIT changed(name, box->currentData().toLongLong());
    });
    return box;
  }
  case capture::ControlKind::Integer:
    break;
  }
  return makeSlider(control);
}

QWidget* ControlForm::makeSlider(const capture::DeviceControl& control) {
  auto* both = new QWidget(this);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kSpacing);
  auto* slider = new QSlider(Qt::Horizontal, both);
  auto* number = new QSpinBox(both);
  slider->setRange(asInt(control.minimum), asInt(control.maximum));
  slider->setSingleStep(asInt(control.step));
  slider->setPageStep(std::max(asInt(control.step), (slider->maximum() - slider->minimum()) / 10));
  number->setRange(slider->minimum(), slider->maximum());
  number->setSingleStep(asInt(control.step));
  number->setKeyboardTracking(false);
  slider->setAccessibleName(controlText(control));
  number->setAccessibleName(controlText(control));
  both->setToolTip(tr("From %1 to %2; default %3")
                       .arg(control.minimum)
                       .arg(control.maximum)
                       .arg(control.defaultValue));
  both->setFocusProxy(slider);
  row->addWidget(slider, 1);
  row->addWidget(number);
  connect(slider, &QSlider::valueChanged, this, [this, number, name = control.name](int value) {
    const QSignalBlocker quiet(number);
    number->setValue(value);
    Q_EMIT changed(name, value);
  });
  connect(number, &QSpinBox::valueChanged, slider, &QSlider::setValue);
  connect(slider, &QSlider::sliderPressed, this, [this] { isDragged_ = true; });
  connect(slider, &QSlider::sliderReleased, this, [this] {
    isDragged_ = false;
    Q_EMIT dragEnded();
  });
  return both;
}

void ControlForm::showValues() {
  for (const capture::DeviceControl& control : controls_) {
    auto* field = findChild<QWidget*>(fieldName(control));
    field->setEnabled(!control.isReadOnly && !control.isInactive);
    if (auto* box = qobject_cast<QCheckBox*>(field)) {
      box->setChecked(control.value != 0);
    } else if (auto* menu = qobject_cast<QComboBox*>(field)) {
      menu->setCurrentIndex(menu->findData(QVariant::fromValue<qint64>(control.value)));
    } else {
      auto* slider = field->findChild<QSlider*>();
      auto* number = field->findChild<QSpinBox*>();
      const QSignalBlocker quietSlider(slider);
      const QSignalBlocker quietNumber(number);
      slider->setValue(asInt(control.value));
      number->setValue(asInt(control.value));
    }
  }
}

void ControlForm::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) {
    rebuild();
    showValues();
  }
}

} // namespace dewpoint::ui

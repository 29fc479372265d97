// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parameter_row.h"

#include "ui/style/symbolic_icon.h"
#include "ui/style/theme.h"
#include "ui/style/type_scale.h"
#include "ui/text/quantity_text.h"
#include "ui/widgets/decimal_field.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr int kSliderSteps = 1000;

int decimalsFor(const ParameterDeclaration& declaration) {
  if (declaration.kind == ParameterKind::Integer || declaration.stepSize <= 0.0) {
    return declaration.kind == ParameterKind::Integer ? 0 : 3;
  }
  return std::clamp(static_cast<int>(std::ceil(-std::log10(declaration.stepSize) - 1e-9)), 0, 6);
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
      box_(new DecimalField(this)), dot_(new QLabel(QStringLiteral("●"), this)),
      reset_(new QToolButton(this)), note_(new QLabel(this)) {
  const QString name = QString::fromStdString(declaration.key);
  setObjectName(QStringLiteral("parameter_") + name);
  slider_->setObjectName(QStringLiteral("slider_") + name);
  box_->setObjectName(QStringLiteral("box_") + name);
  dot_->setObjectName(QStringLiteral("dot_") + name);
  reset_->setObjectName(QStringLiteral("reset_") + name);
  note_->setObjectName(QStringLiteral("note_") + name);
  auto* label =
      new QLabel(QCoreApplication::translate("Parameter", declaration.label.c_str()), this);
  label->setObjectName(QStringLiteral("label_") + name);
  label->setBuddy(box_);
  label->setWordWrap(true); // long words of some languages must not push the numbers out

  slider_->setRange(0, kSliderSteps);
  slider_->setPageStep(kSliderSteps / 20);
  box_->setDecimals(decimalsFor(declaration));
  box_->setRange(declaration.minimum, declaration.maximum);
  box_->setSingleStep(declaration.stepSize > 0.0 ? declaration.stepSize : 1.0);
  box_->setKeyboardTracking(false);
  box_->setAlignment(Qt::AlignRight);
  box_->setMinimumWidth(112);
  box_->setSuffix(unitSuffix(declaration));
  setToolTip(tooltip());
  layOut(label);
  slider_->installEventFilter(this);

  connect(reset_, &QToolButton::clicked, this, &ParameterRow::resetRequested);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int position) { Q_EMIT valueEdited(fromSlider(position)); });
  connect(box_, &QDoubleSpinBox::valueChanged, this, &ParameterRow::valueEdited);
}

void ParameterRow::layOut(QLabel* label) {
  dot_->setForegroundRole(QPalette::Highlight);
  dot_->setFont(smallerFont(font()));
  reset_->setAutoRaise(true);
  reset_->setIconSize({14, 14});
  reset_->setFocusPolicy(Qt::StrongFocus);
  for (QWidget* mark : std::initializer_list<QWidget*>{dot_, reset_}) {
    QSizePolicy policy = mark->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // nothing moves when a value is changed
    mark->setSizePolicy(policy);
    mark->hide();
  }
  note_->setFont(smallerFont(font()));
  note_->setWordWrap(true);
  note_->hide();
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(4);
  grid->addWidget(label, 0, 0);
  grid->addWidget(dot_, 0, 1);
  grid->addWidget(reset_, 0, 2);
  grid->addWidget(box_, 0, 3);
  grid->addWidget(slider_, 1, 0, 1, 4);
  grid->addWidget(note_, 2, 0, 1, 4);
  grid->setColumnStretch(0, 1);
  applyPalette();
}

void ParameterRow::applyPalette() {
  reset_->setIcon(symbolicIcon(QStringLiteral("reset"), palette()));
  QPalette amber = note_->palette();
  const QColor color = trackingStateColor(TrackingState::Searching, palette());
  if (amber.color(QPalette::WindowText) != color) {
    amber.setColor(QPalette::WindowText, color);
    note_->setPalette(amber);
  }
}

void ParameterRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
  }
}

bool ParameterRow::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (watched != slider_ || !isKey) {
    return QWidget::eventFilter(watched, event);
  }
  const auto* key = static_cast<const QKeyEvent*>(event);
  const bool resets = key->modifiers() == Qt::NoModifier &&
                      (key->key() == Qt::Key_Backspace || key->key() == Qt::Key_Delete);
  if (resets && event->type() == QEvent::KeyPress) {
    Q_EMIT resetRequested();
  } else if (resets) {
    event->accept(); // else it could be a shortcut of the window
  }
  return resets || QWidget::eventFilter(watched, event);
}

void ParameterRow::setChanged(bool changed, double defaultValue) {
  dot_->setVisible(changed);
  if (!changed && reset_->hasFocus()) {
    slider_->setFocus(); // the keys stay with this parameter
  }
  reset_->setVisible(changed);
  const QString value = parameterValueText(defaultValue) + unitSuffix(declaration_);
  dot_->setToolTip(
      QCoreApplication::translate("ParameterRow", "Changed: the default is %1.").arg(value));
  reset_->setToolTip(
      QCoreApplication::translate("ParameterRow", "Reset to %1 (Backspace on the slider)")
          .arg(value));
  reset_->setAccessibleName(reset_->toolTip());
}

void ParameterRow::setNote(const QString& note) {
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
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
  const bool factors = d.hasLogarithmicSlider && d.minimum > 0.0;
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
  const bool factors = d.hasLogarithmicSlider && d.minimum > 0.0;
  const double part = factors ? std::log(value / d.minimum) / std::log(d.maximum / d.minimum)
                              : (value - d.minimum) / (d.maximum - d.minimum);
  return static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * kSliderSteps));
}

QString ParameterRow::tooltip() const {
  if (declaration_.isDerivedFromCameras) {
    return QCoreApplication::translate(
               "ParameterRow",
               "%1\nFrom %2 to %3%4; the default comes from the region that the cameras see.")
        .arg(QCoreApplication::translate("Parameter", declaration_.description.c_str()),
             parameterValueText(declaration_.minimum), parameterValueText(declaration_.maximum),
             unitSuffix(declaration_));
  }
  return QCoreApplication::translate("ParameterRow", "%1\nFrom %2 to %3%4; default %5%4.")
      .arg(QCoreApplication::translate("Parameter", declaration_.description.c_str()),
           parameterValueText(declaration_.minimum), parameterValueText(declaration_.maximum),
           unitSuffix(declaration_), parameterValueText(declaration_.defaultValue));
}

} // namespace dewpoint::ui

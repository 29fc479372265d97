// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/color_picker.h"

#include "core/color/color_histogram.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/decimal_field.h"
#include "ui/widgets/hue_ring.h"
#include "ui/widgets/range_bar.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace dewpoint::ui {

namespace {

/// The field of a range that box `index` shows.
double& field(ColorRange& range, std::size_t index) {
  double* const fields[] = {&range.hueMin,        &range.hueMax,       &range.saturationMin,
                            &range.saturationMax, &range.intensityMin, &range.intensityMax};
  return *fields[index];
}

} // namespace

ColorPicker::ColorPicker(QWidget* parent)
    : QWidget(parent), ring_(new HueRing(this)), saturation_(new RangeBar(this)),
      intensity_(new RangeBar(this)) {
  setObjectName(QStringLiteral("colorPicker"));
  ring_->setObjectName(QStringLiteral("hueRing"));
  saturation_->setObjectName(QStringLiteral("saturationBar"));
  intensity_->setObjectName(QStringLiteral("intensityBar"));
  const char* names[] = {"hueFrom",      "hueTo",         "saturationFrom",
                         "saturationTo", "intensityFrom", "intensityTo"};
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const bool hue = i < 2;
    boxes_[i] = addBox(names[i], hue ? 360.0 : 1.0, hue ? 1.0 : 0.01, hue ? 0 : 2,
                       hue ? QStringLiteral("°") : QString());
    connect(boxes_[i], &QDoubleSpinBox::valueChanged, this, [this, i](double value) {
      ColorRange changed = range_;
      field(changed, i) = value;
      applyEdit(changed);
    });
    connect(boxes_[i], &QDoubleSpinBox::editingFinished, this, &ColorPicker::editingFinished);
  }
  boxes_[0]->setWrapping(true);
  boxes_[1]->setWrapping(true);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(8);
  grid->addWidget(ring_, 0, 0, 1, 3);
  QWidget* bars[] = {nullptr, saturation_, intensity_};
  int row = 1;
  for (std::size_t k = 0; k < labels_.size(); ++k) {
    labels_[k] = new QLabel(this);
    labels_[k]->setBuddy(boxes_[2 * k]);
    grid->addWidget(labels_[k], row, 0);
    grid->addWidget(boxes_[2 * k], row, 1);
    grid->addWidget(boxes_[2 * k + 1], row++, 2);
    if (bars[k] != nullptr) {
      grid->addWidget(bars[k], row++, 0, 1, 3);
    }
  }
  grid->setColumnStretch(0, 1);
  grid->setRowStretch(0, 1);
  connect(ring_, &HueRing::rangeEdited, this, [this](double from, double to) {
    ColorRange changed = range_;
    changed.hueMin = from;
    changed.hueMax = to;
    applyEdit(changed);
  });
  connect(saturation_, &RangeBar::rangeEdited, this, [this](double from, double to) {
    ColorRange changed = range_;
    changed.saturationMin = from;
    changed.saturationMax = to;
    applyEdit(changed);
  });
  connect(intensity_, &RangeBar::rangeEdited, this, [this](double from, double to) {
    ColorRange changed = range_;
    changed.intensityMin = from;
    changed.intensityMax = to;
    applyEdit(changed);
  });
  connect(ring_, &HueRing::editingFinished, this, &ColorPicker::editingFinished);
  connect(saturation_, &RangeBar::editingFinished, this, &ColorPicker::editingFinished);
  connect(intensity_, &RangeBar::editingFinished, this, &ColorPicker::editingFinished);
  onRetranslate(this, [this] { retranslateUi(); });
}

QDoubleSpinBox* ColorPicker::addBox(const char* name, double maximum, double step, int decimals,
                                    const QString& suffix) {
  auto* box = new DecimalField(this);
  box->setObjectName(QLatin1String(name));
  box->setRange(0.0, maximum);
  box->setSingleStep(step);
  box->setDecimals(decimals);
  box->setSuffix(suffix);
  box->setKeyboardTracking(false);
  box->setAlignment(Qt::AlignRight);
  return box;
}

void ColorPicker::retranslateUi() {
  labels_[0]->setText(tr("H&ue"));
  labels_[1]->setText(tr("&Saturation"));
  labels_[2]->setText(tr("&Intensity"));
  const QString hints[] = {tr("Start of the hue range, 0 to 360 degrees. If it is larger than the "
                              "end, the range passes through red (0 degrees)"),
                           tr("End of the hue range, 0 to 360 degrees"),
                           tr("Smallest saturation, 0 to 1"),
                           tr("Largest saturation, 0 to 1"),
                           tr("Smallest intensity, 0 to 1"),
                           tr("Largest intensity, 0 to 1")};
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    boxes_[i]->setToolTip(hints[i]);
    boxes_[i]->setAccessibleName(hints[i]);
  }
  const QString how = tr("Drag the ends or the center of the range. Keyboard: Tab selects a "
                         "handle, arrow keys move it (ten times as far with Shift)");
  for (QWidget* hand : std::initializer_list<QWidget*>{ring_, saturation_, intensity_}) {
    hand->setToolTip(how);
  }
  ring_->setAccessibleName(tr("Range of hues"));
  saturation_->setAccessibleName(tr("Range of saturation"));
  intensity_->setAccessibleName(tr("Range of intensity"));
}

void ColorPicker::setRange(const ColorRange& range) {
  range_ = range;
  showRange();
}

void ColorPicker::showRange() {
  ring_->setRange(range_.hueMin, range_.hueMax);
  saturation_->setRange(range_.saturationMin, range_.saturationMax);
  intensity_->setRange(range_.intensityMin, range_.intensityMax);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const QSignalBlocker quiet(boxes_[i]);
    boxes_[i]->setValue(field(range_, i));
  }
  const double width = range_.hueMax - range_.hueMin;
  const double middle = range_.hueMin + (width < 0.0 ? width + 360.0 : width) / 2.0;
  const auto hue = static_cast<float>(std::fmod(middle, 360.0) / 360.0);
  saturation_->setColors(QColor::fromHsvF(hue, 0.0F, 0.75F), QColor::fromHsvF(hue, 1.0F, 0.9F));
  intensity_->setColors(Qt::black, QColor::fromHsvF(hue, 0.35F, 1.0F));
}

void ColorPicker::applyEdit(const ColorRange& range) {
  if (!checkColorRange(range)) {
    showRange(); // it would match nothing: what holds stays
    return;
  }
  range_ = range;
  showRange();
  Q_EMIT rangeEdited(range);
}

void ColorPicker::setHistogram(const ColorHistogram& histogram) {
  ring_->setHistogram({histogram.hue.begin(), histogram.hue.end()});
  saturation_->setHistogram({histogram.saturation.begin(), histogram.saturation.end()});
  intensity_->setHistogram({histogram.intensity.begin(), histogram.intensity.end()});
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_form.h"

#include "core/trajectory/export/export_catalog.h"
#include "ui/export/export_text.h"
#include "ui/preferences/preferences.h"
#include "ui/text/quantity_text.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/decimal_field.h"
#include "ui/widgets/named.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr double kMostSeconds = 1e6;
constexpr double kMostRate = 10000.0;
constexpr double kMostGap = 60.0;

} // namespace

ExportForm::ExportForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
  form_->setContentsMargins(0, 0, 0, 0);
  format_ = named(new QComboBox(this), "exportFormat");
  targets_ = named(new QListWidget(this), "exportTargets");
  targets_->setMaximumHeight(84);
  estimates_ = named(new QComboBox(this), "exportEstimates");
  from_ = makeDecimalField("exportFrom", -1.0, kMostSeconds, 3, this);
  to_ = makeDecimalField("exportTo", -1.0, kMostSeconds, 3, this);
  trackedTo_ = named(new QLabel(this), "exportTrackedTo");
  trackedTo_->setForegroundRole(QPalette::PlaceholderText);
  trackedTo_->hide();
  rate_ = makeDecimalField("exportRate", 0.0, kMostRate, 3, this);
  gaps_ = named(new QComboBox(this), "exportGaps");
  longestGap_ = makeDecimalField("exportLongestGap", 0.01, kMostGap, 2, this);
  longestGap_->setValue(ExportOptions().maxFilledGapSeconds);
  axes_ = named(new QComboBox(this), "exportAxes");
  unit_ = named(new QComboBox(this), "exportUnit");
  notes_ = named(new QCheckBox(this), "exportHeader");
  notes_->setChecked(Preferences().exportsNotes());
  from_->setValue(from_->minimum());
  to_->setValue(to_->minimum());
  proposedRange_ = {from_->value(), to_->value()};
  form_->setSpacing(8);
  auto* end = new QHBoxLayout;
  end->setSpacing(8);
  end->addWidget(to_, 1);
  end->addWidget(trackedTo_);
  trackedTo_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed); // the row is not stretched
  const auto row = [this, end](QWidget* field) {
    auto* label = new QLabel(this);
    label->setBuddy(field);
    labels_[field] = label;
    if (field == to_) {
      form_->addRow(label, end);
    } else {
      form_->addRow(label, field);
    }
  };
  for (QWidget* field : std::initializer_list<QWidget*>{format_, targets_, estimates_, from_, to_,
                                                        rate_, gaps_, longestGap_, axes_, unit_}) {
    row(field);
  }
  form_->addRow(QString(), notes_);
  connect(format_, &QComboBox::currentIndexChanged, this, [this] {
    notes_->setEnabled(format().hasNotes);
    updateUsualChoices();
    Q_EMIT formatChanged();
  });
  const auto change = [this] {
    longestGap_->setEnabled(gaps_->currentIndex() == 1 || estimates_->currentIndex() == 1);
    showTrackedEnd();
    Q_EMIT changed();
  };
  for (QComboBox* box : {estimates_, gaps_, axes_, unit_}) {
    connect(box, &QComboBox::currentIndexChanged, this, change);
  }
  for (QDoubleSpinBox* spin : {from_, to_, rate_, longestGap_}) {
    connect(spin, &QDoubleSpinBox::valueChanged, this, change);
  }
  connect(notes_, &QCheckBox::toggled, this, [this, change](bool checked) {
    Preferences().setExportsNotes(checked);
    change();
  });
  connect(targets_, &QListWidget::itemChanged, this, change);
  longestGap_->setEnabled(false);
}

void ExportForm::retranslateUi() {
  fillChoices();
  const auto setTexts = [this](QWidget* field, const QString& label, const QString& hint) {
    labels_.at(field)->setText(label);
    field->setAccessibleName(label);
    field->setToolTip(hint);
  };
  setTexts(format_, tr("Format"), tr("The program that will read the file"));
  setTexts(targets_, tr("Targets"),
           tr("Only checked targets are exported; if none is checked, all are exported"));
  setTexts(estimates_, tr("Estimates"),
           tr("As tracked: estimated during the run, from earlier frames alone. Smoothed: "
              "estimated after the run, from earlier and later frames"));
  setTexts(from_, tr("From"), tr("Earliest time to export, 0 to 1,000,000 s"));
  setTexts(to_, tr("To"), tr("Latest time to export, 0 to 1,000,000 s"));
  setTexts(rate_, tr("Rate"),
           tr("Rows per second, 0.001 to 10,000. Positions between frames are interpolated"));
  setTexts(gaps_, tr("Gaps"), tr("What to write while the position is unknown"));
  setTexts(longestGap_, tr("Longest gap"), tr("Longest gap to fill, 0.01 to 60 s"));
  setTexts(axes_, tr("World axes"), tr("Axis that points up in the file"));
  setTexts(unit_, tr("Lengths"), tr("Unit of positions in the file"));
  from_->setSpecialValueText(tr("the beginning"));
  to_->setSpecialValueText(tr("the end"));
  rate_->setSpecialValueText(tr("as recorded"));
  for (QDoubleSpinBox* spin : {from_, to_, longestGap_}) {
    spin->setSuffix(tr(" s"));
  }
  rate_->setSuffix(tr(" per second"));
  notes_->setText(notesText());
  showTrackedEnd();
  notes_->setToolTip(notesHint());
}

QString ExportForm::notesText() {
  return tr("Notes at the top of the file");
}

QString ExportForm::notesHint() {
  return tr("Lines that describe the run: method, seed, parameters, units and axes. Without them, "
            "a CSV file begins with the names of its columns. TRC and C3D files have no notes");
}

void ExportForm::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  notes_->setChecked(Preferences().exportsNotes()); // another dialog may have changed it
}

const ExportFormat& ExportForm::format() const {
  return exportFormats()[static_cast<std::size_t>(std::max(0, format_->currentIndex()))];
}

void ExportForm::fillChoices() {
  QStringList formats;
  for (const ExportFormat& format : exportFormats()) {
    formats << exportFormatName(format.id);
  }
  setChoices(*format_, formats);
  setChoices(*estimates_, {tr("as tracked (live)"), tr("smoothed after the run")});
  setChoices(*gaps_, {tr("leave"), tr("fill")});
  setChoices(*axes_, {QString(), tr("Z up"), tr("Y up")});
  setChoices(*unit_, {QString(), tr("meters"), tr("millimeters")});
  updateUsualChoices();
}

void ExportForm::updateUsualChoices() {
  const TableDefaults& usual = format().tableDefaults;
  const auto show = [](QComboBox& box, int row) {
    box.setItemText(0, tr("%1 (usual for this format)").arg(box.itemText(row)));
  };
  show(*axes_, usual.axes == WorldAxes::ZUp ? 1 : 2);
  show(*unit_, usual.unit == LengthUnit::Meter ? 1 : 2);
}

void ExportForm::showTrackedEnd() {
  const double beyond = lastTime_ ? to_->value() - *lastTime_ : 0.0;
  const bool isBeyond = beyond >= std::pow(10.0, -to_->decimals()); // more than rounding
  if (isBeyond) {
    // So many decimals that the two times differ.
    trackedTo_->setText(
        tr("tracked only up to %1").arg(secondsText(*lastTime_, beyond < 0.1 ? 3 : 1)));
  }
  trackedTo_->setVisible(isBeyond);
  to_->setAccessibleDescription(isBeyond ? trackedTo_->text() : QString());
}

void ExportForm::setTrajectory(const Trajectory& trajectory) {
  QStringList names;
  lastTime_.reset();
  for (const TrajectorySample& sample : trajectory.samples) {
    lastTime_ = std::max(lastTime_.value_or(sample.time), sample.time);
    const QString name = QString::fromStdString(sample.target);
    if (!names.contains(name)) {
      names << name;
    }
  }
  QStringList shown;
  for (int i = 0; i < targets_->count(); ++i) {
    shown << targets_->item(i)->text();
  }
  showTrackedEnd();
  if (names == shown) {
    return;
  }
  const QSignalBlocker quiet(targets_);
  targets_->clear();
  for (const QString& name : names) {
    auto* item = new QListWidgetItem(name, targets_);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
  }
}

ExportOptions ExportForm::options() const {
  ExportOptions options;
  options.format = format().id;
  for (int i = 0; i < targets_->count(); ++i) {
    if (targets_->item(i)->checkState() == Qt::Checked) {
      options.targets.push_back(targets_->item(i)->text().toStdString());
    }
  }
  if (from_->value() >= 0.0) {
    options.rangeBegin = RangeBound{from_->value(), false};
  }
  if (to_->value() >= 0.0) {
    options.rangeEnd = RangeBound{to_->value(), false};
  }
  if (rate_->value() > 0.0) {
    options.rowsPerSecond = rate_->value();
  }
  options.gapRule = gaps_->currentIndex() == 1 ? GapRule::Fill : GapRule::LeaveEmpty;
  options.maxFilledGapSeconds = longestGap_->value();
  if (axes_->currentIndex() > 0) {
    options.axes = axes_->currentIndex() == 1 ? WorldAxes::ZUp : WorldAxes::YUp;
  }
  if (unit_->currentIndex() > 0) {
    options.unit = unit_->currentIndex() == 1 ? LengthUnit::Meter : LengthUnit::Millimeter;
  }
  options.writesHeader = notes_->isChecked();
  options.usesSmoothedEstimates = estimates_->currentIndex() == 1;
  options.exportDate = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  return options;
}

QString ExportForm::suffix() const {
  return QString::fromUtf8(format().suffix.data());
}

bool ExportForm::exportsLiveEstimates() const {
  return estimates_->currentIndex() == 0;
}

void ExportForm::setSelectedRange(std::optional<std::pair<double, double>> seconds) {
  const std::pair<double, double> all(from_->minimum(), to_->minimum());
  if (!seconds && std::pair(from_->value(), to_->value()) != proposedRange_) {
    return; // typed by hand since
  }
  // Outwards to what the fields can show, or rounding would lose the last frame.
  const double steps = std::pow(10.0, from_->decimals());
  from_->setValue(seconds ? std::floor(seconds->first * steps) / steps : all.first);
  to_->setValue(seconds ? std::ceil(seconds->second * steps) / steps : all.second);
  proposedRange_ = seconds ? std::pair(from_->value(), to_->value()) : all;
}

void ExportForm::resetChoices() {
  for (QDoubleSpinBox* spin : {from_, to_, rate_}) {
    spin->setValue(spin->minimum());
  }
  longestGap_->setValue(ExportOptions().maxFilledGapSeconds);
  for (QComboBox* box : {estimates_, gaps_, axes_, unit_}) {
    box->setCurrentIndex(0);
  }
  proposedRange_ = {from_->value(), to_->value()};
}

} // namespace dewpoint::ui

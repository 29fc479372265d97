// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of the export dialog: which there are, where they stand, what they say.
#include "ui/export/export_dialog.h"
#include "ui/export/export_text.h"
#include "ui/widgets/decimal_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr double kMostSeconds = 1e6;
constexpr double kMostRate = 10000.0;
constexpr double kMostGap = 60.0;

template <class Widget> Widget* named(Widget* widget, const char* name) {
  widget->setObjectName(QLatin1String(name));
  return widget;
}

QDoubleSpinBox* makeSpin(QWidget* parent, const char* name, double low, double high, int decimals) {
  auto* spin = named(new DecimalField(parent), name);
  spin->setRange(low, high);
  spin->setDecimals(decimals);
  spin->setKeyboardTracking(false);
  return spin;
}

/// Fills a box with choices; the chosen one stays.
void setChoices(QComboBox* box, const QStringList& texts) {
  const QSignalBlocker quiet(box);
  const int before = std::max(0, box->currentIndex());
  box->clear();
  box->addItems(texts);
  box->setCurrentIndex(before);
}

} // namespace

void ExportDialog::makeFields() {
  format_ = named(new QComboBox(this), "exportFormat");
  targets_ = named(new QListWidget(this), "exportTargets");
  targets_->setMaximumHeight(84);
  estimates_ = named(new QComboBox(this), "exportEstimates");
  from_ = makeSpin(this, "exportFrom", -1.0, kMostSeconds, 3);
  to_ = makeSpin(this, "exportTo", -1.0, kMostSeconds, 3);
  rate_ = makeSpin(this, "exportRate", 0.0, kMostRate, 3);
  gaps_ = named(new QComboBox(this), "exportGaps");
  longestGap_ = makeSpin(this, "exportLongestGap", 0.01, kMostGap, 2);
  longestGap_->setValue(ExportOptions().longestGap);
  axes_ = named(new QComboBox(this), "exportAxes");
  unit_ = named(new QComboBox(this), "exportUnit");
  header_ = named(new QCheckBox(this), "exportHeader");
  header_->setChecked(true);
  preview_ = named(new QPlainTextEdit(this), "exportPreview");
  preview_->setReadOnly(true);
  preview_->setLineWrapMode(QPlainTextEdit::NoWrap);
  preview_->setTabChangesFocus(true);
  preview_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  units_ = named(new QLabel(this), "exportUnits");
  units_->setWordWrap(true);
  size_ = named(new QLabel(this), "exportSize");
  size_->setWordWrap(true);
  question_ = named(new QLabel(this), "exportQuestion");
  question_->setWordWrap(true);
  question_->hide();
  file_ = named(new QLineEdit(this), "exportFile");
  browse_ = named(new QPushButton(this), "exportBrowse");
  progress_ = named(new QProgressBar(this), "exportProgress");
  progress_->setRange(0, 100);
  cancel_ = named(new QPushButton(this), "exportCancel");
  figure_ = named(new QPushButton(this), "exportFigure");
  export_ = named(new QPushButton(this), "exportStart");
  close_ = named(new QPushButton(this), "exportClose");
  // Enter in a field ends typing, no more.
  for (QPushButton* button : {browse_, cancel_, figure_, export_, close_}) {
    button->setAutoDefault(false);
  }
  from_->setValue(from_->minimum());
  to_->setValue(to_->minimum());
}

void ExportDialog::arrangeFields() {
  form_ = new QFormLayout;
  form_->setSpacing(8);
  const auto row = [this](QWidget* field) {
    auto* label = new QLabel(this);
    label->setBuddy(field);
    form_->addRow(label, field);
  };
  for (QWidget* field : std::initializer_list<QWidget*>{format_, targets_, estimates_, from_, to_,
                                                        rate_, gaps_, longestGap_, axes_, unit_}) {
    row(field);
  }
  form_->addRow(QString(), header_);
  auto* right = new QVBoxLayout;
  right->setSpacing(8);
  right->addWidget(units_);
  right->addWidget(size_);
  right->addWidget(preview_, 1);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  columns->addLayout(form_);
  columns->addLayout(right, 1);
  auto* place = new QHBoxLayout;
  place->setSpacing(8);
  place->addWidget(file_, 1);
  place->addWidget(browse_);
  // No accept role: Enter would press it.
  auto* box = new QDialogButtonBox(this);
  box->addButton(figure_, QDialogButtonBox::ActionRole);
  box->addButton(export_, QDialogButtonBox::ActionRole);
  box->addButton(close_, QDialogButtonBox::RejectRole);
  connect(box, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addWidget(progress_, 1);
  buttons->addWidget(cancel_);
  buttons->addStretch(1);
  buttons->addWidget(box);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 16);
  layout->setSpacing(16);
  layout->addLayout(columns, 1);
  layout->addLayout(place);
  layout->addWidget(question_);
  layout->addLayout(buttons);
}

void ExportDialog::retranslate() {
  setWindowTitle(tr("Export trajectory"));
  fillChoices();
  const auto say = [this](QWidget* field, const QString& label, const QString& hint) {
    qobject_cast<QLabel*>(form_->labelForField(field))->setText(label);
    field->setAccessibleName(label);
    field->setToolTip(hint);
  };
  say(format_, tr("Format"), tr("Which program is to read it"));
  say(targets_, tr("Targets"), tr("Those with a mark are exported; all, if none has one"));
  say(estimates_, tr("Estimates"),
      tr("As they were known live, or as all frames before and after tell"));
  say(from_, tr("From"), tr("First time, 0 to 1,000,000 s"));
  say(to_, tr("To"), tr("Last time, 0 to 1,000,000 s"));
  say(rate_, tr("Rate"), tr("Rows per second, 0.001 to 10,000; interpolated"));
  say(gaps_, tr("Gaps"), tr("What to write where the target is not known"));
  say(longestGap_, tr("Longest gap"), tr("A longer gap is left, 0.01 to 60 s"));
  say(axes_, tr("World axes"), tr("Which axis points up in the file"));
  say(unit_, tr("Lengths"), tr("Unit of positions in the file"));
  from_->setSpecialValueText(tr("the beginning"));
  to_->setSpecialValueText(tr("the end"));
  rate_->setSpecialValueText(tr("as recorded"));
  for (QDoubleSpinBox* spin : {from_, to_, longestGap_}) {
    spin->setSuffix(tr(" s"));
  }
  rate_->setSuffix(tr(" per second"));
  header_->setText(tr("Notes about the run"));
  header_->setToolTip(tr("Method, seed, parameters, units and axes as comments in the file"));
  preview_->setAccessibleName(tr("First lines of the file"));
  preview_->setToolTip(tr("First lines of the file"));
  units_->setAccessibleName(tr("Units and axes"));
  size_->setAccessibleName(tr("Size"));
  file_->setAccessibleName(tr("File"));
  file_->setToolTip(tr("File to write"));
  browse_->setText(tr("Browse…"));
  browse_->setToolTip(tr("Choose the file to write"));
  progress_->setAccessibleName(tr("Progress"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop the work under way; what is there already stays as it was"));
  figure_->setText(tr("Figure…"));
  figure_->setToolTip(tr("Write a figure of it as SVG or PDF: x, y, z over time and from above"));
  forgetQuestion(); // in the new language
  export_->setToolTip(tr("Write the file in the background"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close; an export that is under way goes on"));
  changed();
}

void ExportDialog::fillChoices() {
  QStringList formats;
  for (const ExportFormat& format : exportFormats()) {
    formats << exportFormatName(format.id);
  }
  setChoices(format_, formats);
  setChoices(estimates_, {tr("live"), tr("smoothed after the run")});
  setChoices(gaps_, {tr("leave"), tr("fill")});
  setChoices(axes_, {tr("as usual in the format"), tr("Z up"), tr("Y up")});
  setChoices(unit_, {tr("as usual in the format"), tr("meters"), tr("millimeters")});
}

} // namespace dewpoint::ui

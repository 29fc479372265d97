// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/experiment_dialog.h"

#include "core/experiment/studies/figure_experiments.h"
#include "ui/jobs/background_job.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFont>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QUrl>
#include <QVBoxLayout>

namespace dewpoint::ui {

namespace {

QString words(std::string_view text) {
  return QCoreApplication::translate("Experiment", std::string(text).c_str());
}

} // namespace

ExperimentDialog::ExperimentDialog(QWidget* parent)
    : QDialog(parent), job_(new BackgroundJob(this)), list_(new QListWidget(this)),
      description_(new QLabel(this)), runsLabel_(new QLabel(this)), runs_(new QSpinBox(this)),
      clothesLabel_(new QLabel(this)), clothes_(new QComboBox(this)),
      recordingsLabel_(new QLabel(this)), recordings_(new QLineEdit(this)),
      browseRecordings_(new QPushButton(this)), folderLabel_(new QLabel(this)),
      folder_(new QLineEdit(this)), browse_(new QPushButton(this)),
      progress_(new QProgressBar(this)), state_(new QLabel(this)), run_(new QPushButton(this)),
      cancel_(new QPushButton(this)), open_(new QPushButton(this)), close_(new QPushButton(this)) {
  setObjectName(QStringLiteral("experimentDialog"));
  makeFields();
  fillList();
  connect(list_, &QListWidget::currentRowChanged, this, &ExperimentDialog::showChosen);
  connect(browse_, &QPushButton::clicked, this,
          [this] { chooseFolder(folder_, tr("Folder of the report")); });
  connect(browseRecordings_, &QPushButton::clicked, this,
          [this] { chooseFolder(recordings_, tr("Recordings folder")); });
  connect(cancel_, &QPushButton::clicked, job_, &BackgroundJob::cancel);
  connect(open_, &QPushButton::clicked, this, &ExperimentDialog::openReport);
  connect(job_, &BackgroundJob::progressChanged, this, [this](double part) {
    progress_->setRange(0, part < 0.0 ? 0 : 1000);
    progress_->setValue(static_cast<int>(part * progress_->maximum()));
  });
  connect(job_, &BackgroundJob::ended, this, [this](bool canceled) {
    showRunning(false);
    if (canceled) {
      state_->setText(tr("Canceled."));
    }
  });
  showRunning(false);
  list_->setCurrentRow(1); // below the first heading
  onRetranslate(this, [this] { retranslateUi(); });
}

void ExperimentDialog::fillList() {
  for (const FigureExperiment* experiment : listedExperiments()) {
    const bool begins = rows_.empty() || rows_.back()->group != experiment->group;
    if (begins) {
      auto* heading = new QListWidgetItem(list_);
      heading->setFlags(Qt::NoItemFlags); // neither chosen nor stepped on
      QFont font = list_->font();
      font.setBold(true);
      heading->setFont(font);
      rows_.push_back(nullptr);
    }
    rows_.push_back(experiment);
    auto* item = new QListWidgetItem(list_);
    item->setData(Qt::UserRole, QString::fromUtf8(experiment->name.data()));
  }
}

void ExperimentDialog::showRunning(bool running) {
  // What is shown is what runs: nothing can be chosen meanwhile.
  for (QWidget* part : std::initializer_list<QWidget*>{list_, runs_, clothes_, recordings_,
                                                       browseRecordings_, folder_, browse_, run_}) {
    part->setEnabled(!running);
  }
  progress_->setVisible(running);
  progress_->setRange(0, 0); // until it says how far it is
  cancel_->setVisible(running);
}

void ExperimentDialog::makeFields() {
  const std::initializer_list<std::pair<QWidget*, const char*>> names{
      {list_, "experimentList"},
      {runs_, "experimentRuns"},
      {clothes_, "experimentClothes"},
      {recordings_, "experimentRecordings"},
      {browseRecordings_, "experimentBrowseRecordings"},
      {folder_, "experimentFolder"},
      {browse_, "experimentBrowse"},
      {progress_, "experimentProgress"},
      {state_, "experimentState"},
      {run_, "experimentRun"},
      {cancel_, "experimentCancel"},
      {open_, "experimentOpen"},
      {close_, "experimentClose"}};
  for (const auto& [widget, name] : names) {
    widget->setObjectName(QLatin1String(name));
  }
  runs_->setRange(1, 10000);
  description_->setWordWrap(true);
  state_->setWordWrap(true);
  state_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  progress_->setTextVisible(false);
  open_->setEnabled(false);
  run_->setDefault(true);
  runsLabel_->setBuddy(runs_);
  clothesLabel_->setBuddy(clothes_);
  recordingsLabel_->setBuddy(recordings_);
  folderLabel_->setBuddy(folder_);
  recordings_->setText(qEnvironmentVariable("DEWPOINT_DATA"));
  for (int row = 0; row < 3; ++row) {
    clothes_->addItem({}); // in the order of StudyClothes
  }
  auto* folderRow = new QHBoxLayout;
  folderRow->addWidget(folder_, 1);
  folderRow->addWidget(browse_);
  auto* form = new QFormLayout;
  form->setSpacing(8);
  form->addRow(runsLabel_, runs_);
  form->addRow(clothesLabel_, clothes_);
  auto* recordingsRow = new QHBoxLayout;
  recordingsRow->addWidget(recordings_, 1);
  recordingsRow->addWidget(browseRecordings_);
  form->addRow(recordingsLabel_, recordingsRow);
  form->addRow(folderLabel_, folderRow);
  auto* progressRow = new QHBoxLayout;
  progressRow->addWidget(progress_, 1);
  progressRow->addWidget(cancel_);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(run_, QDialogButtonBox::AcceptRole);
  buttons->addButton(open_, QDialogButtonBox::ActionRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::accepted, this, &ExperimentDialog::run);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(10);
  column->addWidget(list_, 1);
  column->addWidget(description_);
  column->addLayout(form);
  column->addLayout(progressRow);
  column->addWidget(state_);
  column->addWidget(buttons);
  resize(560, 520);
}

void ExperimentDialog::retranslateUi() {
  setWindowTitle(tr("Experiments"));
  list_->setAccessibleName(tr("Experiments"));
  runsLabel_->setText(tr("Runs per case"));
  runs_->setToolTip(tr("How often each case is run, each time with another seed. More runs take "
                       "longer and give more certain results."));
  clothesLabel_->setText(tr("Clothes"));
  clothes_->setToolTip(tr("Whether the simulated people wear different clothes"));
  clothes_->setItemText(0, tr("both kinds"));
  clothes_->setItemText(1, tr("different"));
  clothes_->setItemText(2, tr("similar"));
  recordingsLabel_->setText(tr("Recordings"));
  recordings_->setPlaceholderText(tr("no folder: only a rendered clip"));
  recordings_->setToolTip(tr("Folder with the recordings juggle1 and otb; without a folder, only a "
                             "rendered clip is used"));
  browseRecordings_->setText(tr("Choose…"));
  browseRecordings_->setToolTip(tr("Choose the folder of the recordings"));
  folderLabel_->setText(tr("Folder"));
  folder_->setToolTip(tr("Folder for the report, its pictures and its numbers"));
  browse_->setText(tr("Choose…"));
  browse_->setToolTip(tr("Choose the folder of the report"));
  progress_->setAccessibleName(tr("Experiment progress"));
  run_->setText(tr("Run"));
  run_->setToolTip(tr("Run the chosen experiment (Enter)"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop the experiment without writing anything"));
  open_->setText(tr("Open the report"));
  open_->setToolTip(tr("Show the last report in the web browser"));
  close_->setText(tr("Close"));
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const FigureExperiment* experiment = rows_[row];
    list_->item(static_cast<int>(row))
        ->setText(experiment != nullptr ? words(experiment->title)
                                        : words(experimentGroupTitle(rows_[row + 1]->group)));
  }
  showChosen();
}

/// The first one where a heading, or nothing, is current.
const FigureExperiment& ExperimentDialog::chosen() const {
  const int row = list_->currentRow();
  const auto* experiment = row < 0 ? nullptr : rows_[static_cast<std::size_t>(row)];
  return experiment != nullptr ? *experiment : *rows_[1];
}

void ExperimentDialog::showChosen() {
  description_->setText(words(chosen().description));
  runs_->setValue(chosen().runCount);
  clothesLabel_->setVisible(chosen().hasClothesOption);
  clothes_->setVisible(chosen().hasClothesOption);
  for (QWidget* part :
       std::initializer_list<QWidget*>{recordingsLabel_, recordings_, browseRecordings_}) {
    part->setVisible(chosen().usesRecordings);
  }
  const QString home = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  folder_->setText(
      QDir(home).filePath(QStringLiteral("dewpoint-") + QString::fromUtf8(chosen().name.data())));
}

void ExperimentDialog::chooseFolder(QLineEdit* into, const QString& title) {
  const QString folder = QFileDialog::getExistingDirectory(this, title, into->text());
  if (!folder.isEmpty()) {
    into->setText(folder);
  }
}

void ExperimentDialog::run() {
  ExperimentOptions options;
  options.outputFolder = folder_->text().trimmed().toStdString();
  options.runCount = runs_->value();
  options.clothes = static_cast<StudyClothes>(clothes_->currentIndex());
  if (chosen().usesRecordings) {
    options.recordingsFolder = recordings_->text().trimmed().toStdString();
  }
  if (options.outputFolder.empty()) {
    state_->setText(tr("Choose the folder for the report first."));
    return;
  }
  const FigureExperiment& experiment = chosen();
  const bool begun =
      job_->start([this, options, &experiment](const BackgroundJob::Progress& progress) {
        ExperimentOptions watched = options;
        watched.progress = progress;
        const Status made = experiment.run(watched);
        return std::function<void()>([this, options, made, &experiment] {
          if (made) {
            finish(QString::fromStdString((options.outputFolder / experiment.reportFile).string()));
          } else {
            state_->setText(errorText(made.error()));
            Q_EMIT failed(errorText(made.error()));
          }
        });
      });
  if (begun) {
    report_.clear();
    open_->setEnabled(false);
    showRunning(true);
    state_->setText(tr("Running “%1”…").arg(words(experiment.title)));
  }
}

void ExperimentDialog::finish(const QString& report) {
  report_ = report;
  open_->setEnabled(true);
  state_->setText(tr("The report is in %1.").arg(report));
  if (isVisible()) {
    openReport();
  }
}

void ExperimentDialog::openReport() {
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(report_))) {
    state_->setText(
        tr("No program was found that can show the report. The report is in %1.").arg(report_));
  }
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/project_check_dialog.h"

#include "core/session/session_inputs.h"
#include "core/setup/doctor/doctor.h"
#include "ui/jobs/background_job.h"
#include "ui/style/system_colors.h"
#include "ui/style/theme.h"
#include "ui/text/finding_text.h"
#include "ui/text/retranslation.h"

#include <QCheckBox>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr QSize kCheckSize(680, 520);

/// Each level has a shape, not only a color.
QString markOf(FindingLevel level) {
  switch (level) {
  case FindingLevel::Ok:
    return QStringLiteral("✓");
  case FindingLevel::Note:
    return QStringLiteral("◆");
  case FindingLevel::Problem:
    break;
  }
  return QStringLiteral("▲");
}

QColor colorOf(FindingLevel level, const QPalette& palette) {
  switch (level) {
  case FindingLevel::Ok:
    return palette.color(QPalette::PlaceholderText);
  case FindingLevel::Note:
    return trackingStateColor(TrackingState::Ambiguous, palette);
  case FindingLevel::Problem:
    break;
  }
  return trackingStateColor(TrackingState::Lost, palette);
}

/// Work for another thread: it owns all that it uses.
std::vector<Finding> findingsOf(const Project& project, const ProjectOpener& opener,
                                bool decodesEveryFrame, const BackgroundJob::Progress& progress) {
  ExaminationOptions options;
  options.decodesEveryFrame = decodesEveryFrame;
  options.open = [&opener](const Project& opened) -> Result<std::unique_ptr<FrameSetSource>> {
    auto inputs = opener(SessionRequest(opened));
    if (!inputs) {
      return tl::make_unexpected(inputs.error());
    }
    return std::move(inputs->source);
  };
  options.shouldContinue = progress;
  auto findings = examine(project, options);
  std::ranges::stable_sort(findings, std::ranges::greater(), &Finding::level);
  return findings;
}

} // namespace

ProjectCheckDialog::ProjectCheckDialog(std::function<Project()> project, ProjectOpener opener,
                                       QWidget* parent)
    : QDialog(parent), project_(std::move(project)), opener_(std::move(opener)),
      job_(new BackgroundJob(this)), summary_(new QLabel(this)), list_(new QTextBrowser(this)),
      everyFrame_(new QCheckBox(this)), progress_(new QProgressBar(this)),
      check_(new QPushButton(this)), cancel_(new QPushButton(this)), copy_(new QPushButton(this)),
      close_(new QPushButton(this)) {
  setObjectName(QStringLiteral("projectCheck"));
  arrange();
  connect(check_, &QPushButton::clicked, this, &ProjectCheckDialog::start);
  connect(cancel_, &QPushButton::clicked, job_, &BackgroundJob::cancel);
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(plainText()); });
  connect(job_, &BackgroundJob::progressChanged, this, [this](double part) {
    progress_->setValue(static_cast<int>(part * progress_->maximum()));
  });
  connect(job_, &BackgroundJob::ended, this, [this](bool canceled) {
    isCanceled_ = canceled;
    showRunning(false);
    fillList();
    Q_EMIT checkEnded();
  });
  onRetranslate(this, [this] { retranslateUi(); });
  resize(kCheckSize);
  start();
}

void ProjectCheckDialog::arrange() {
  summary_->setObjectName(QStringLiteral("checkSummary"));
  summary_->setWordWrap(true);
  QFont bold = summary_->font();
  bold.setWeight(QFont::DemiBold);
  summary_->setFont(bold);
  list_->setObjectName(QStringLiteral("checkList"));
  everyFrame_->setObjectName(QStringLiteral("checkEveryFrame"));
  check_->setObjectName(QStringLiteral("checkAgain"));
  cancel_->setObjectName(QStringLiteral("checkCancel"));
  copy_->setObjectName(QStringLiteral("checkCopy"));
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  auto* progressRow = new QHBoxLayout;
  progressRow->addWidget(progress_, 1);
  progressRow->addWidget(cancel_);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(check_, QDialogButtonBox::ActionRole);
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  close_->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(summary_);
  column->addWidget(list_, 1);
  column->addLayout(progressRow);
  column->addWidget(everyFrame_);
  column->addWidget(buttons);
}

bool ProjectCheckDialog::isRunning() const {
  return job_->isRunning();
}

void ProjectCheckDialog::start() {
  showRunning(true);
  job_->start([this, project = project_(), opener = opener_, every = everyFrame_->isChecked()](
                  const BackgroundJob::Progress& progress) -> std::function<void()> {
    auto findings = findingsOf(project, opener, every, progress);
    return [this, findings = std::move(findings)]() mutable { findings_ = std::move(findings); };
  });
  fillList();
}

void ProjectCheckDialog::showRunning(bool running) {
  progress_->setValue(0);
  progress_->setVisible(running);
  cancel_->setVisible(running);
  check_->setEnabled(!running);
  everyFrame_->setEnabled(!running);
  copy_->setEnabled(!running);
}

QString ProjectCheckDialog::summary() const {
  if (isRunning()) {
    return tr("Checking recordings, times, calibration, colors and method…");
  }
  if (isCanceled_) {
    return tr("The check was canceled.");
  }
  const auto count = [this](FindingLevel level) {
    return static_cast<int>(std::ranges::count(findings_, level, &Finding::level));
  };
  const int problems = count(FindingLevel::Problem);
  return problems > 0 ? tr("%n problem(s) must be solved before this project can be tracked.",
                           nullptr, problems)
         : count(FindingLevel::Note) > 0 ? tr("No problems, but look at the points marked ◆.")
                                         : tr("No problems.");
}

void ProjectCheckDialog::fillList() {
  summary_->setText(summary());
  const QString soft = palette().color(QPalette::PlaceholderText).name();
  QString page;
  for (const Finding& finding : findings_) {
    const QColor color = colorOf(finding.level(), palette());
    page += QStringLiteral("<p style=\"margin: 0 0 10px 0\"><span style=\"color: %1\">%2</span> %3")
                .arg(color.name(), markOf(finding.level()), findingText(finding).toHtmlEscaped());
    if (const QString advice = findingAdvice(finding); !advice.isEmpty()) {
      page += QStringLiteral("<br/>→ %1").arg(advice.toHtmlEscaped());
    }
    if (const QString place = findingLocationText(finding);
        !place.isEmpty() && finding.level() != FindingLevel::Ok) {
      page += QStringLiteral("<br/><span style=\"color: %1\">%2</span>")
                  .arg(soft, place.toHtmlEscaped());
    }
    page += QStringLiteral("</p>");
  }
  list_->setHtml(isRunning() || isCanceled_ ? QString() : page);
}

QString ProjectCheckDialog::plainText() const {
  QStringList lines;
  for (const Finding& finding : findings_) {
    lines += QString::fromStdString(findingLine(finding));
  }
  return lines.join(QLatin1Char('\n'));
}

void ProjectCheckDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    fillList();
  }
}

void ProjectCheckDialog::retranslateUi() {
  setWindowTitle(tr("Check project – Dewpoint"));
  list_->setAccessibleName(tr("Result of the check"));
  progress_->setAccessibleName(tr("Progress of the check"));
  everyFrame_->setText(tr("Read every frame"));
  everyFrame_->setToolTip(tr("Find damaged frames anywhere in a recording: all frames are read, "
                             "not only a few of them. This takes longer"));
  check_->setText(tr("Check again"));
  check_->setToolTip(tr("Check the project as it is now"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop the check"));
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Copy the result as English text, for example for a bug report"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close this window"));
  fillList();
}

} // namespace dewpoint::ui

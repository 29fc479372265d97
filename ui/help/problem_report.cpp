// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/problem_report.h"

#include "ui/help/window_self_test.h"
#include "ui/jobs/background_job.h"
#include "ui/text/retranslation.h"
#include "ui/view3d/gl_context.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSysInfo>
#include <QThread>
#include <QVBoxLayout>
#include <opencv2/core/version.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr QSize kReportSize(640, 520);

QString openGlText() {
  GlContext context;
  if (const std::string failure = context.start(); !failure.empty()) {
    return QString::fromStdString(failure);
  }
  QOpenGLFunctions* gl = QOpenGLContext::currentContext()->functions();
  const auto text = [gl](unsigned int what) {
    return QString::fromUtf8(reinterpret_cast<const char*>(gl->glGetString(what)));
  };
  const QString found = QStringLiteral("%1, %2").arg(text(GL_RENDERER), text(GL_VERSION));
  context.doneCurrent();
  return found;
}

/// In English, for those who read it. Not translated.
QString reportText(const ProblemFacts& facts) {
  QStringList lines{
      QStringLiteral("Dewpoint %1").arg(QStringLiteral(DEWPOINT_VERSION)),
      QStringLiteral("Qt %1 (%2), OpenCV %3, VTK %4")
          .arg(QString::fromLatin1(qVersion()), QGuiApplication::platformName(),
               QStringLiteral(CV_VERSION), QStringLiteral(DEWPOINT_VTK_VERSION)),
      QStringLiteral("OpenGL: %1").arg(openGlText()),
      QStringLiteral("System: %1, %2, %3 cores")
          .arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture())
          .arg(QThread::idealThreadCount()),
      QStringLiteral("Language: %1 (system: %2)").arg(QLocale().name(), QLocale::system().name()),
      QStringLiteral("Project: %1").arg(facts.projectDescription),
      QString(),
      QStringLiteral("Last messages:")};
  lines += facts.messages.isEmpty() ? QStringList{QStringLiteral("(none)")} : facts.messages;
  if (!facts.crashReport.isEmpty()) {
    lines += {QString(), QStringLiteral("Report of the crash:"), facts.crashReport.trimmed()};
  }
  return lines.join(QLatin1Char('\n'));
}

} // namespace

ProblemReport::ProblemReport(const ProblemFacts& facts, ProjectOpener opener, QWidget* parent)
    : QDialog(parent), opener_(std::move(opener)), job_(new BackgroundJob(this)),
      facts_(reportText(facts)), intro_(new QLabel(this)), text_(new QPlainTextEdit(this)),
      progress_(new QProgressBar(this)), test_(new QPushButton(this)), copy_(new QPushButton(this)),
      close_(new QPushButton(this)) {
  setObjectName(QStringLiteral("problemReport"));
  arrange();
  connect(test_, &QPushButton::clicked, this, [this] {
    if (job_->isRunning()) {
      job_->cancel();
    } else {
      startTest();
    }
  });
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(text()); });
  connect(job_, &BackgroundJob::ended, this, [this](bool canceled) {
    if (canceled) {
      showTest(QStringLiteral("(canceled)"));
    }
    showRunning(false);
    Q_EMIT selfTestEnded();
  });
  showTest(QStringLiteral("(not run)"));
  onRetranslate(this, [this] { retranslateUi(); });
  showRunning(false);
  resize(kReportSize);
}

void ProblemReport::arrange() {
  intro_->setWordWrap(true);
  text_->setObjectName(QStringLiteral("problemText"));
  text_->setReadOnly(true);
  text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  progress_->setRange(0, 0); // it does not know how far it is
  progress_->setTextVisible(false);
  test_->setObjectName(QStringLiteral("problemTest"));
  copy_->setObjectName(QStringLiteral("problemCopy"));
  copy_->setDefault(true);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(test_, QDialogButtonBox::ActionRole);
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(intro_);
  column->addWidget(text_, 1);
  column->addWidget(progress_);
  column->addWidget(buttons);
}

void ProblemReport::startTest() {
  std::vector<SelfTestLine> graphics = runGraphicsSelfTest(); // belongs to this thread
  job_->start([this, lines = std::move(graphics), parts = makeSelfTestInputs(opener_)](
                  const BackgroundJob::Progress& progress) mutable -> std::function<void()> {
    constexpr double kUnknown = -1.0;
    parts.shouldContinue = [&progress] { return progress(kUnknown); };
    std::ranges::move(runSelfTest(parts), std::back_inserter(lines));
    return [this, result = selfTestReport(lines)] { showTest(result); };
  });
  showTest(QStringLiteral("(running)"));
  showRunning(true);
}

void ProblemReport::showTest(const QString& result) {
  text_->setPlainText(facts_ + QStringLiteral("\n\nSelf-test:\n") + result);
}

void ProblemReport::showRunning(bool running) {
  progress_->setVisible(running);
  copy_->setEnabled(!running);
  test_->setText(running ? tr("Cancel") : tr("Run self-test"));
  test_->setToolTip(running ? tr("Stop the self-test")
                            : tr("Test graphics, codecs, cameras and disk, and track a simulated "
                                 "scene for a few seconds"));
}

QString ProblemReport::text() const {
  return text_->toPlainText();
}

void ProblemReport::retranslateUi() {
  setWindowTitle(tr("Report a problem – Dewpoint"));
  intro_->setText(tr("Write to whoever gave you Dewpoint. Describe what you did, what you expected "
                     "and what happened. Run the self-test. Attach the text below and, if you can, "
                     "the project file and a screenshot. Nothing is sent automatically."));
  text_->setAccessibleName(tr("Text for the report"));
  progress_->setAccessibleName(tr("Progress of the self-test"));
  showRunning(job_->isRunning());
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Copy the text so that you can paste it into an email or a form"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close this window"));
}

} // namespace dewpoint::ui

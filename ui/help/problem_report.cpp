// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/problem_report.h"

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
#include <QPushButton>
#include <QSysInfo>
#include <QThread>
#include <QVBoxLayout>
#include <opencv2/core/version.hpp>

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
QString reportText(const QStringList& messages, const QString& project) {
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
      QStringLiteral("Project: %1").arg(project),
      QString(),
      QStringLiteral("Last messages:")};
  lines += messages.isEmpty() ? QStringList{QStringLiteral("(none)")} : messages;
  return lines.join(QLatin1Char('\n'));
}

} // namespace

ProblemReport::ProblemReport(const QStringList& messages, const QString& project, QWidget* parent)
    : QDialog(parent), intro_(new QLabel(this)), text_(new QPlainTextEdit(this)),
      copy_(new QPushButton(this)), close_(new QPushButton(this)) {
  setObjectName(QStringLiteral("problemReport"));
  intro_->setWordWrap(true);
  text_->setObjectName(QStringLiteral("problemText"));
  text_->setReadOnly(true);
  text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  text_->setPlainText(reportText(messages, project));
  copy_->setObjectName(QStringLiteral("problemCopy"));
  copy_->setDefault(true);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(text()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(intro_);
  column->addWidget(text_, 1);
  column->addWidget(buttons);
  onRetranslate(this, [this] { retranslateUi(); });
  resize(kReportSize);
}

QString ProblemReport::text() const {
  return text_->toPlainText();
}

void ProblemReport::retranslateUi() {
  setWindowTitle(tr("Report a problem – Dewpoint"));
  intro_->setText(tr("Write to whoever gave you Dewpoint. Describe what you did, what you expected "
                     "and what happened. Attach the text below and, if you can, the project file "
                     "and a screenshot. Nothing is sent automatically."));
  text_->setAccessibleName(tr("Text for the report"));
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Copy the text, to be pasted into a mail or a form"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close this window"));
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/calibration_choice.h"

#include "ui/start/calibration_fit.h"
#include "ui/style/spacing.h"
#include "ui/style/theme.h"
#include "ui/text/calibration_files.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/file_choice.h"
#include "ui/widgets/named_widgets.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace dewpoint::ui {

CalibrationChoice::CalibrationChoice(QWidget* parent)
    : QWidget(parent), label_(new QLabel(this)), name_(new QLabel(this)),
      drop_(makeButton("newDropCalibration", this)),
      choose_(makeButton("newChooseCalibration", this)), result_(new QLabel(this)),
      fit_(new CalibrationFit(this)) {
  name_->setObjectName(QStringLiteral("newCalibrationFile"));
  name_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  result_->setObjectName(QStringLiteral("newCalibrationResult"));
  result_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->setSpacing(kSpacing);
  row->addWidget(label_);
  row->addWidget(name_, 1);
  row->addWidget(drop_);
  row->addWidget(choose_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(kSpacing / 2);
  all->addLayout(row);
  all->addWidget(result_);
  all->addWidget(fit_);
  connect(fit_, &CalibrationFit::changed, this, &CalibrationChoice::showResult);
  connect(choose_, &QPushButton::clicked, this, &CalibrationChoice::choose);
  connect(drop_, &QPushButton::clicked, this, [this] { setFile({}); });
  onRetranslate(this, [this] { retranslateUi(); });
}

QWidget* CalibrationChoice::lastButtonInTabOrder() const {
  return drop_;
}

void CalibrationChoice::retranslateUi() {
  label_->setText(tr("Calibration file:"));
  choose_->setText(tr("Import calibration…"));
  choose_->setToolTip(tr("A calibration file of Dewpoint or another program. Cameras are matched "
                         "by name, or by order if the names differ"));
  drop_->setText(tr("None"));
  drop_->setToolTip(tr("Continue without a calibration file"));
  showResult();
}

void CalibrationChoice::choose() {
  const QString file = askForFile(this, tr("Import a calibration"), calibrationFileFilter());
  if (!file.isEmpty()) {
    setFile(file);
  }
}

void CalibrationChoice::startNewProject(bool acceptsProposals) {
  acceptsProposals_ = acceptsProposals;
  useFile({});
}

void CalibrationChoice::setFile(const QString& file) {
  acceptsProposals_ = false;
  useFile(file);
}

void CalibrationChoice::proposeFile(const QString& file) {
  if (acceptsProposals_ && file != file_) {
    useFile(file);
  }
}

void CalibrationChoice::useFile(const QString& file) {
  file_ = file;
  checked_.reset();
  fit_->reset();
  checking_.cancel();
  showResult();
  if (file.isEmpty()) {
    return;
  }
  checking_.start([this, file](const BackgroundJob::Progress&) {
    const CheckedCalibration checked = checkCalibration(file.toStdString());
    return [this, checked] {
      checked_ = checked;
      showResult();
    };
  });
}

void CalibrationChoice::setCameraNames(std::vector<std::string> names) {
  if (names != cameras_) {
    cameras_ = std::move(names);
    showResult();
  }
}

CalibrationAdaptation CalibrationChoice::adaptation() const {
  return fit_->adaptation();
}

bool CalibrationChoice::isNameQuestionShown() const {
  return fit_->isNameQuestionShown();
}

void CalibrationChoice::showImageChangeQuestion() {
  fit_->showImageChangeQuestion();
}

QString CalibrationChoice::resultText(const CheckedCalibration& checked, bool& good) const {
  good = false;
  const QString title = QString::fromStdString(checked.formatTitle);
  if (checked.problem) {
    Error problem = *checked.problem;
    problem.file.clear(); // it stands above
    const QString reason = errorText(problem);
    if (checked.needsInput) {
      return tr("Recognized: %1. The file does not contain everything: %2. Create the project "
                "without this file, then choose Calibration › Import calibration and enter what is "
                "missing.")
          .arg(title, reason);
    }
    if (!title.isEmpty()) {
      return tr("Recognized: %1. It cannot be used: %2.").arg(title, reason);
    }
    if (problem.code != ErrorCode::NotParsed) {
      return tr("The file cannot be used: %1.").arg(reason);
    }
    return tr("Not recognized. Dewpoint reads: %1.").arg(calibrationFormatTitles());
  }
  const int count = static_cast<int>(checked.cameras.size());
  if (!cameras_.empty() && matchCameras(cameras_, checked.cameras) == CameraMatch::None &&
      !fit_->areNamesMatched()) {
    QStringList names;
    for (const std::string& camera : checked.cameras) {
      names << QString::fromStdString(camera);
    }
    return tr("Recognized: %1. The cameras in the file do not match the cameras above: %2.")
        .arg(title, names.join(QStringLiteral(", ")));
  }
  good = true;
  return tr("✓ Recognized: %1, %n cameras", nullptr, count).arg(title);
}

void CalibrationChoice::showResult() {
  const QString name = QFileInfo(file_).fileName();
  name_->setText(file_.isEmpty()     ? tr("None: the camera positions will only be guesses")
                 : acceptsProposals_ ? tr("%1 (found beside the recordings)").arg(name)
                                     : name);
  name_->setToolTip(file_);
  drop_->setVisible(!file_.isEmpty());
  result_->setVisible(!file_.isEmpty());
  fit_->setCameraNames(cameras_, checked_ ? checked_->cameras : std::vector<std::string>());
  bool good = true;
  result_->setText(checked_ ? resultText(*checked_, good) : tr("Reading…"));
  QPalette colors = palette();
  colors.setColor(
      QPalette::WindowText,
      !checked_ ? palette().color(QPalette::PlaceholderText)
                : trackingStateColor(good ? TrackingState::Held : TrackingState::Lost, palette()));
  result_->setPalette(colors);
}

void CalibrationChoice::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    showResult();
  }
}

} // namespace dewpoint::ui

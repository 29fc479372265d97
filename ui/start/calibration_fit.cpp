// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/calibration_fit.h"

#include "core/setup/calibration/calibration_check.h"
#include "ui/style/spacing.h"
#include "ui/text/calibration_files.h"
#include "ui/text/camera_names.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/choice_field.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {

CalibrationFit::CalibrationFit(QWidget* parent)
    : QWidget(parent), fitRow_(new QWidget(this)), fitLabel_(new QLabel(fitRow_)),
      fit_(makeChoiceField("newCalibrationFit", fitRow_)), namesRow_(new QWidget(this)),
      namesLabel_(new QLabel(namesRow_)), names_(new QFormLayout) {
  fitLabel_->setBuddy(fit_);
  namesLabel_->setWordWrap(true);
  auto* fitRow = new QHBoxLayout(fitRow_);
  fitRow->setContentsMargins(0, 0, 0, 0);
  fitRow->setSpacing(kSpacing);
  fitRow->addWidget(fitLabel_);
  fitRow->addWidget(fit_, 1);
  auto* namesRow = new QVBoxLayout(namesRow_);
  namesRow->setContentsMargins(0, 0, 0, 0);
  namesRow->addWidget(namesLabel_);
  namesRow->addLayout(names_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(kSpacing / 2);
  all->addWidget(namesRow_);
  all->addWidget(fitRow_);
  connect(fit_, &QComboBox::currentIndexChanged, this, &CalibrationFit::changed);
  onRetranslate(this, [this] { retranslateUi(); });
  reset();
}

void CalibrationFit::retranslateUi() {
  fitLabel_->setText(tr("Change since the calibration:"));
  const QString hint =
      tr("How the images differ from those of the calibration, if they have another "
         "size");
  setChoicesWithData(*fit_, sizeFitChoices());
  fit_->setAccessibleName(tr("Change of the images since the calibration"));
  fit_->setToolTip(hint);
  namesLabel_->setText(tr("For each camera of the project, choose a camera of the file:"));
  fillNames();
}

void CalibrationFit::reset() {
  fitRow_->hide();
  fit_->setCurrentIndex(0);
  cameras_.clear();
  inFile_.clear();
  fillNames();
}

void CalibrationFit::showImageChangeQuestion() {
  fitRow_->show();
}

void CalibrationFit::setCameraNames(const std::vector<std::string>& cameras,
                                    const std::vector<std::string>& inFile) {
  if (cameras != cameras_ || inFile != inFile_) {
    cameras_ = cameras;
    inFile_ = inFile;
    fillNames();
  }
}

void CalibrationFit::fillNames() {
  std::vector<QString> chosen;
  for (const QComboBox* choice : choices_) {
    chosen.push_back(choice->currentData().toString());
  }
  while (names_->rowCount() > 0) {
    names_->removeRow(0);
  }
  choices_.clear();
  const bool isNeeded = !cameras_.empty() && std::ranges::find(cameras_, "") == cameras_.end() &&
                        inFile_.size() >= cameras_.size() &&
                        matchCameras(cameras_, inFile_) == CameraMatch::None;
  for (std::size_t k = 0; isNeeded && k < cameras_.size(); ++k) {
    auto* choice = makeChoiceField(
        QByteArray("newCalibrationName" + QByteArray::number(static_cast<int>(k))).constData(),
        this);
    const QString own = QString::fromStdString(cameras_[k]);
    ChoicesWithData rows;
    if (std::ranges::find(inFile_, cameras_[k]) == inFile_.end()) {
      rows.emplace_back(tr("Choose…"), QString());
    }
    for (const std::string& name : inFile_) {
      rows.emplace_back(QString::fromStdString(name), QString::fromStdString(name));
    }
    setChoicesWithData(*choice, rows);
    const int before = choice->findData(k < chosen.size() ? chosen[k] : QString());
    const int same = choice->findData(own);
    choice->setCurrentIndex(std::max(0, before > 0 ? before : same));
    choice->setAccessibleName(cameraName(cameras_[k], k));
    connect(choice, &QComboBox::currentIndexChanged, this, &CalibrationFit::changed);
    names_->addRow(cameraName(cameras_[k], k), choice);
    choices_.push_back(choice);
  }
  namesRow_->setVisible(isNeeded);
}

CalibrationAdaptation CalibrationFit::adaptation() const {
  CalibrationAdaptation answers;
  answers.sizeFit = parseSizeFit(fit_->currentData().toString().toStdString());
  for (std::size_t k = 0; k < choices_.size(); ++k) {
    const std::string name = choices_[k]->currentData().toString().toStdString();
    if (!name.empty() && name != cameras_[k]) {
      answers.cameraRenaming[cameras_[k]] = name;
    }
  }
  return answers;
}

bool CalibrationFit::areNamesMatched() const {
  std::vector<std::string> used;
  for (std::size_t k = 0; k < choices_.size(); ++k) {
    used.push_back(choices_[k]->currentData().toString().toStdString());
  }
  std::ranges::sort(used);
  return !used.empty() && !used.front().empty() && std::ranges::adjacent_find(used) == used.end();
}

} // namespace dewpoint::ui

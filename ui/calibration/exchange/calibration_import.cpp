// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/exchange/calibration_import.h"

#include "core/calibration/formats/format_catalog.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/text/calibration_files.h"
#include "ui/text/camera_agreement_text.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/file_choice.h"
#include "ui/widgets/number_field.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QVariant>

namespace dewpoint::ui {

CalibrationImportDialog::CalibrationImportDialog(Document& document, const CameraListModel& cameras,
                                                 QWidget* parent)
    : ExchangeDialog(QStringLiteral("calibrationImport"), parent), document_(document),
      cameras_(cameras), format_(addComboBox("Format")), unit_(addComboBox("Unit")),
      lens_(addComboBox("Lens")), size_(new QLineEdit(this)), poses_(addComboBox("Poses")),
      camera_(addComboBox("Camera")), fit_(addComboBox("Fit")), names_(new QWidget(this)),
      folder_(new QPushButton(this)) {
  size_->setObjectName(QStringLiteral("calibrationImportSize"));
  folder_->setObjectName(QStringLiteral("calibrationImportFolder"));
  unit_->setEditable(true);
  unit_->setInsertPolicy(QComboBox::NoInsert);
  addButton(folder_);
  for (QWidget* field : std::initializer_list<QWidget*>{format_, unit_, lens_, size_, poses_,
                                                        camera_, fit_, names_}) {
    labels_.push_back(addRow(field));
  }
  auto* rows = new QFormLayout(names_);
  rows->setContentsMargins(0, 0, 0, 0);
  fillNames({});
  connect(folder_, &QPushButton::clicked, this, [this] {
    const QString folder = askForFolder(this, tr("Choose a folder"));
    if (!folder.isEmpty()) {
      setFile(folder);
    }
  });
  connect(&document_, &Document::projectReplaced, this, &QDialog::close);
  const auto follow = [this] {
    fillCameras();
    fillNames({});
    refresh(); // what is taken has the names, too
  };
  connect(&cameras_, &CameraListModel::dataChanged, this, follow);
  connect(&cameras_, &CameraListModel::modelReset, this, [this, follow] {
    const QSignalBlocker quiet(camera_);
    camera_->setCurrentIndex(0); // the row that was chosen may be of another camera now
    follow();
  });
  finishLayout();
}

void CalibrationImportDialog::chooseFile() {
  const QString chosen = QFileDialog::getOpenFileName(
      this, tr("Import a calibration"), QFileInfo(file()).path(), calibrationFileFilter());
  if (!chosen.isEmpty()) {
    setFile(chosen);
  }
}

void CalibrationImportDialog::fillCameras() {
  ChoicesWithData choices = {{tr("match by name"), {}}};
  for (int camera = 0; camera < cameras_.rowCount(); ++camera) {
    choices.emplace_back(tr("import only for %1").arg(cameras_.nameOf(camera)), camera);
  }
  setChoicesWithData(*camera_, choices);
}

void CalibrationImportDialog::fillNames(const QStringList& inFile) {
  const auto isChosen = [](const QComboBox* choice) { return choice->currentIndex() > 0; };
  QStringList missing; // names of the project
  for (int camera = 0; camera < cameras_.rowCount(); ++camera) {
    if (!inFile.contains(cameras_.nameOf(camera))) {
      missing << cameras_.nameOf(camera);
    }
  }
  const bool isNeeded = inFile.size() > 1 && !missing.isEmpty();
  if (inFile != namesInFile_ || inFile.isEmpty()) {
    namesInFile_ = inFile;
    auto* rows = static_cast<QFormLayout*>(names_->layout());
    while (rows->rowCount() > 0) {
      rows->removeRow(0);
    }
    nameChoices_.clear();
    for (int camera = 0; isNeeded && camera < cameras_.rowCount(); ++camera) {
      QComboBox* choice = addComboBox(QByteArray("Name" + QByteArray::number(camera)).constData());
      ChoicesWithData choices = {{tr("match automatically"), {}}};
      for (const QString& name : inFile) {
        choices.emplace_back(name, name);
      }
      setChoicesWithData(*choice, choices);
      choice->setAccessibleName(cameras_.nameOf(camera));
      choice->setToolTip(tr("For each camera of the project, choose the camera in the file from "
                            "which it gets its calibration"));
      connect(choice, &QComboBox::currentIndexChanged, this, &CalibrationImportDialog::refresh);
      rows->addRow(cameras_.nameOf(camera), choice);
      nameChoices_.push_back(choice);
    }
  }
  const bool isShown = isNeeded || std::ranges::any_of(nameChoices_, isChosen);
  names_->setVisible(isShown);
  labels_.back()->setVisible(isShown);
}

void CalibrationImportDialog::retranslateFields() {
  setWindowTitle(tr("Import a calibration"));
  fileLabel_->setText(tr("File"));
  folder_->setText(tr("Folder…"));
  folder_->setAccessibleName(tr("Choose a folder"));
  folder_->setToolTip(tr("Choose a folder with one file per camera"));
  accept_->setText(tr("Apply calibration"));
  accept_->setToolTip(tr("Use the calibration in the project; you can undo this"));
  const QString own = tr("as in the file");
  ChoicesWithData formats = {{tr("detect automatically"), {}}};
  for (const CalibrationFormat& format : calibrationFormats()) {
    formats.emplace_back(QString::fromUtf8(format.title), QLatin1String(format.name));
  }
  setChoicesWithData(*format_, formats);
  setChoicesWithData(*unit_, {{own, {}},
                              {tr("meters"), QStringLiteral("m")},
                              {tr("millimeters"), QStringLiteral("mm")},
                              {tr("centimeters"), QStringLiteral("cm")},
                              {tr("inches"), QStringLiteral("in")},
                              {tr("feet"), QStringLiteral("ft")}});
  setChoicesWithData(*lens_, {{own, {}},
                              {tr("k1 k2 p1 p2 (pinhole)"), QStringLiteral("pinhole")},
                              {tr("k1 k2 k3 k4 (fisheye)"), QStringLiteral("fisheye")}});
  setChoicesWithData(*poses_, {{tr("default of the format"), {}},
                               {tr("from world to camera"), QStringLiteral("no")},
                               {tr("from camera to world"), QStringLiteral("yes")}});
  setChoicesWithData(*fit_, sizeFitChoices());
  size_->setPlaceholderText(own);
  fillCameras();
  fillNames({});
  const std::pair<QString, QString> names[] = {
      {tr("Format"), tr("The program that wrote the file")},
      {tr("Unit"), tr("Unit of the lengths in the file; or enter the length of one unit in meters, "
                      "such as 0.025 for squares of 25 mm")},
      {tr("Lens model (4 coefficients)"), tr("Meaning of the four lens coefficients")},
      {tr("Image size"), tr("Width and height in pixels, such as 1280x720")},
      {tr("Poses"), tr("Direction of the transformation that the file stores as a pose")},
      {tr("Camera"),
       tr("Project camera that gets the calibration, if the file contains only one camera")},
      {tr("Project images"), tr("How the images of the project differ from those of the "
                                "calibration, if they have another size")},
      {tr("Names in the file"), tr("For each camera of the project, choose the camera in the file "
                                   "from which it gets its calibration")}};
  QWidget* const fields[] = {format_, unit_, lens_, size_, poses_, camera_, fit_, names_};
  for (std::size_t k = 0; k < labels_.size(); ++k) {
    labels_[k]->setText(names[k].first);
    fields[k]->setAccessibleName(names[k].first);
    fields[k]->setToolTip(names[k].second);
  }
}

ImportRequest CalibrationImportDialog::request() const {
  ImportRequest request;
  request.path = file().toStdString();
  request.hints.format = format_->currentData().toString().toStdString();
  const int listed = unit_->findText(unit_->currentText());
  const QString unit = listed >= 0 ? unit_->itemData(listed).toString() : unit_->currentText();
  request.hints.metersPerUnit = parseLengthUnit(unit.trimmed().toStdString());
  const QString lens = lens_->currentData().toString();
  if (!lens.isEmpty()) {
    request.hints.lens = lens == QLatin1String("fisheye") ? LensModel::Fisheye : LensModel::Pinhole;
  }
  static const QRegularExpression kSize(
      QStringLiteral("^\\s*(\\d{1,6})\\s*[x×*]\\s*(\\d{1,6})\\s*$"));
  if (const auto size = kSize.match(size_->text()); size.hasMatch()) {
    request.hints.imageSize = {size.captured(1).toInt(), size.captured(2).toInt()};
  }
  const QString poses = poses_->currentData().toString();
  if (!poses.isEmpty()) {
    request.hints.posesAreWorldFromCamera = poses == QLatin1String("yes");
  }
  if (const QVariant camera = camera_->currentData(); camera.isValid()) {
    request.camera = static_cast<std::size_t>(camera.toInt());
  }
  request.adaptation.sizeFit = parseSizeFit(fit_->currentData().toString().toStdString());
  for (std::size_t k = 0; k < nameChoices_.size(); ++k) {
    if (const QString name = nameChoices_[k]->currentData().toString(); !name.isEmpty()) {
      request.adaptation.cameraRenaming[cameras_.nameOf(static_cast<int>(k)).toStdString()] =
          name.toStdString();
    }
  }
  return request;
}

ExchangeDialog::Preview CalibrationImportDialog::makePreview() {
  import_.reset();
  return [this, project = document_.project(), request = request()] {
    const auto made =
        std::make_shared<Result<CalibrationImport>>(importCalibration(project, request));
    QStringList inFile;
    for (const std::string& name : cameraNamesIn(request)) {
      inFile << QString::fromStdString(name);
    }
    return [this, made, inFile] {
      fillNames(inFile);
      applyResult(*made);
    };
  };
}

void CalibrationImportDialog::highlightQuestion(ImportQuestion question) {
  for (std::size_t k = 0; k < labels_.size(); ++k) {
    QFont font = labels_[k]->font();
    font.setBold(static_cast<int>(question) == static_cast<int>(k) + 1);
    labels_[k]->setFont(font);
  }
}

void CalibrationImportDialog::applyError(const Error& error) {
  const ImportProblem asked = importProblem(error);
  const QString sentence = errorText(asked.error);
  highlightQuestion(asked.question);
  QString text = QStringLiteral("⚠ ") + sentence;
  if (asked.question != ImportQuestion::None) {
    const QString label = labels_[static_cast<std::size_t>(asked.question) - 1]->text();
    const bool isMisfit =
        asked.question == ImportQuestion::Fit || asked.question == ImportQuestion::Names;
    text += QStringLiteral("\n\n") +
            (isMisfit ? tr("The calibration does not fit the project. Set “%1” above.")
                      : tr("The file lacks a required value. Set “%1” above."))
                .arg(label);
  }
  showPreview(text, false);
  if (!isTyping()) {
    Q_EMIT failed(sentence);
  }
}

void CalibrationImportDialog::applyResult(const Result<CalibrationImport>& made) {
  if (!made) {
    applyError(made.error());
    return;
  }
  highlightQuestion(ImportQuestion::None);
  import_ = std::make_shared<const CalibrationImport>(*made);
  QStringList lines;
  for (const std::string& decision : made->decisions) {
    lines << QString::fromStdString(decision);
  }
  if (made->wereCamerasMatchedByOrder) {
    lines << tr("The calibration uses other camera names. The cameras were matched by order.");
  }
  if (made->hasOnlyIntrinsics) {
    lines << tr("The file contains no pose. Only the intrinsics are imported; the camera keeps its "
                "current pose.");
  }
  QStringList names;
  for (int camera = 0; camera < cameras_.rowCount(); ++camera) {
    names << cameras_.nameOf(camera);
  }
  for (const CameraDisagreement& fault : made->likelyMistakes) {
    lines << QStringLiteral("⚠ ") +
                 tr("Probably a mistake: %1").arg(disagreementText(fault, names));
  }
  lines << QString();
  for (const ImportedCamera& camera : made->cameras) {
    lines << tr("%1 (in the file: %2): moves by %3 and rotates by %4")
                 .arg(cameras_.nameOf(static_cast<int>(camera.camera)),
                      QString::fromStdString(camera.fileName),
                      lengthText(camera.poseChange.meters, LengthScale::Centimeters, 1),
                      angleText(camera.poseChange.radians, 2));
  }
  lines << tr("After the import, projected points are at most %1 away from where the file projects "
              "them")
               .arg(pixelDifferenceText(made->maxConversionErrorPx));
  showPreview(lines.join(QLatin1Char('\n')), true);
}

void CalibrationImportDialog::performExchange() {
  if (!isReady() || !import_) {
    return;
  }
  const auto edited = document_.edit(tr("Import calibration"), [this](Project& project) {
    for (std::size_t k = 0; k < std::min(project.cameras.size(), import_->project.cameras.size());
         ++k) {
      project.cameras[k].camera = import_->project.cameras[k].camera;
      project.cameras[k].hasOwnCalibration = import_->project.cameras[k].hasOwnCalibration;
    }
  });
  if (!edited) {
    Q_EMIT failed(errorText(edited.error()));
    return;
  }
  Q_EMIT completed(tr("The cameras now use the calibration from %1.").arg(file()));
  close();
}

} // namespace dewpoint::ui

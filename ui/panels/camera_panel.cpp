// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/camera_panel.h"

#include "core/base/units.h"
#include "core/project/project.h"
#include "core/setup/calibration/calibrated_project.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/panels/background_image_taker.h"
#include "ui/panels/delay_estimate.h"
#include "ui/selection/selection.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/path_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {
namespace {

constexpr double kMostLate = 3.6e6; ///< milliseconds
constexpr double kLateSteps = 10.0; ///< shown of a millisecond

} // namespace

CameraPanel::CameraPanel(Document& document, Selection& selection, CameraListModel& cameras,
                         QWidget* parent)
    : QWidget(parent), document_(document), selection_(selection), cameras_(cameras),
      list_(new QListView(this)), nameLabel_(new QLabel(this)), name_(new QLineEdit(this)),
      sourceLabel_(new QLabel(this)), source_(new PathField(this)), browse_(new QPushButton(this)),
      backgroundImageLabel_(new QLabel(this)), backgroundImage_(new PathField(this)),
      backgroundImageBrowse_(new QPushButton(this)), backgroundImageTake_(new QPushButton(this)),
      rotationLabel_(new QLabel(this)), rotation_(new QComboBox(this)),
      mirror_(new QCheckBox(this)), delayLabel_(new QLabel(this)),
      delay_(makeNumberField(QStringLiteral("cameraLate"), {-kMostLate, kMostLate, 1.0, 1}, this)),
      delayEstimate_(new DelayEstimate(this)), calibration_(new QLabel(this)),
      load_(new QPushButton(this)),
      taker_(new BackgroundImageTaker(document, selection, cameras, this)) {
  setObjectName(QStringLiteral("cameraPanel"));
  list_->setModel(&cameras_);
  makeFields();
  onRetranslate(this, [this] { retranslateUi(); });
  connectFields();
}

void CameraPanel::makeFields() {
  list_->setObjectName(QStringLiteral("cameraList"));
  name_->setObjectName(QStringLiteral("cameraName"));
  source_->setObjectName(QStringLiteral("cameraSource"));
  browse_->setObjectName(QStringLiteral("cameraBrowse"));
  backgroundImage_->setObjectName(QStringLiteral("cameraBackgroundImage"));
  backgroundImageBrowse_->setObjectName(QStringLiteral("cameraBackgroundImageBrowse"));
  backgroundImageTake_->setObjectName(QStringLiteral("cameraBackgroundImageTake"));
  rotation_->setObjectName(QStringLiteral("cameraTurn"));
  mirror_->setObjectName(QStringLiteral("cameraMirror"));
  load_->setObjectName(QStringLiteral("cameraLoadCalibration"));
  calibration_->setObjectName(QStringLiteral("cameraCalibration"));
  calibration_->setWordWrap(true);
  calibration_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  addRotationChoices(*rotation_);
  nameLabel_->setBuddy(name_);
  sourceLabel_->setBuddy(source_);
  rotationLabel_->setBuddy(rotation_);
  backgroundImageLabel_->setBuddy(backgroundImage_);
  delayLabel_->setBuddy(delay_);
  auto* form = new QFormLayout;
  form->setSpacing(8);
  form->addRow(nameLabel_, name_);
  form->addRow(sourceLabel_, source_);
  form->addRow(nullptr, browse_);
  form->addRow(rotationLabel_, rotation_);
  form->addRow(nullptr, mirror_);
  form->addRow(delayLabel_, delay_);
  form->addRow(delayEstimate_);
  form->addRow(backgroundImageLabel_, backgroundImage_);
  form->addRow(nullptr, backgroundImageBrowse_);
  form->addRow(backgroundImageTake_); // beside the other, the panel would be wider than its dock
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(list_, 1);
  column->addLayout(form);
  column->addWidget(calibration_);
  column->addWidget(load_);
}

void CameraPanel::connectFields() {
  connect(&document_, &Document::projectReplaced, this, &CameraPanel::refresh);
  connect(&document_, &Document::sourcesChanged, this, &CameraPanel::refresh);
  connect(&document_, &Document::calibrationChanged, this, &CameraPanel::showChosen);
  connect(&document_, &Document::backgroundImagesChanged, this, &CameraPanel::showChosen);
  connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (current.isValid()) {
              selection_.selectCamera(current.row());
            }
          });
  connect(&selection_, &Selection::cameraSelected, this, &CameraPanel::refresh);
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    edit(tr("Rename camera"), [this](ProjectCamera& camera) {
      camera.camera.name = name_->text().trimmed().toStdString();
    });
  });
  connect(source_, &QLineEdit::editingFinished, this, [this] {
    edit(tr("Change image source"), [this](ProjectCamera& camera) {
      camera.location = source_->text().trimmed().toStdString();
    });
  });
  connect(rotation_, &QComboBox::activated, this, [this](int index) {
    orient(tr("Rotate images"), rotation_->itemData(index).toInt(), mirror_->isChecked());
  });
  connect(mirror_, &QCheckBox::clicked, this, [this](bool mirrored) {
    orient(tr("Mirror images"), rotation_->currentData().toInt(), mirrored);
  });
  connect(delay_, &QDoubleSpinBox::editingFinished, this, [this] {
    edit(tr("Change delay"), [this](ProjectCamera& camera) {
      const double shown = std::round(inMilliseconds(camera.delay) * kLateSteps) / kLateSteps;
      if (delay_->value() != shown) { // what is not shown of it must not be lost
        camera.delay = fromMilliseconds(delay_->value());
      }
    });
  });
  connect(delayEstimate_, &DelayEstimate::delayAccepted, this, [this](double delay) {
    edit(tr("Keep estimated delay"), [delay](ProjectCamera& camera) {
      camera.delay = std::clamp(camera.delay + delay, -fromMilliseconds(kMostLate),
                                fromMilliseconds(kMostLate));
    });
  });
  connect(browse_, &QPushButton::clicked, this, &CameraPanel::relocate);
  connect(backgroundImage_, &QLineEdit::editingFinished, this,
          [this] { setBackgroundImage(backgroundImage_->text().trimmed()); });
  connect(backgroundImageBrowse_, &QPushButton::clicked, this, &CameraPanel::chooseBackgroundImage);
  connect(backgroundImageTake_, &QPushButton::clicked, this, [this] { taker_->capture(chosen()); });
  connect(taker_, &BackgroundImageTaker::busyChanged, this, &CameraPanel::updateTakeButton);
  connect(load_, &QPushButton::clicked, this, &CameraPanel::calibrationImportRequested);
}

void CameraPanel::retranslateUi() {
  cameras_.retranslateUi();
  list_->setAccessibleName(tr("Cameras"));
  nameLabel_->setText(tr("Name"));
  name_->setToolTip(tr("Name of the camera, in views and files"));
  sourceLabel_->setText(tr("Images"));
  source_->setToolTip(tr("Video file, image folder, device, or stream address"));
  browse_->setText(tr("Choose…"));
  browse_->setToolTip(tr("Choose the file, folder or device of this camera"));
  rotationLabel_->setText(tr("Rotated"));
  rotation_->setToolTip(tr("How far the images are rotated clockwise before they are used. The "
                           "calibration is rotated with them"));
  mirror_->setText(tr("Mirrored"));
  mirror_->setToolTip(tr("Mirror the images left to right, after rotation"));
  delayLabel_->setText(tr("Delay"));
  delay_->setSuffix(tr(" ms"));
  delay_->setToolTip(tr("How late this camera's images are, in ms. Dewpoint uses this delay to "
                        "synchronize the cameras. Calibration with a wand can measure the delay"));
  delay_->setAccessibleName(tr("Delay of the images in milliseconds"));
  backgroundImageLabel_->setText(tr("Background image"));
  backgroundImage_->setToolTip(
      tr("Image, video or image folder that shows the scene without any target. Objects in the "
         "background that have the target's color are then not mistaken for the target"));
  backgroundImageBrowse_->setText(tr("Choose…"));
  backgroundImageBrowse_->setAccessibleName(tr("Choose background image"));
  backgroundImageBrowse_->setToolTip(
      tr("Choose an image or a video of the scene without any target"));
  backgroundImageTake_->setText(tr("Use current image as background"));
  backgroundImageTake_->setToolTip(
      tr("Save the current image of this camera as its background image"));
  load_->setText(tr("Import calibration…"));
  load_->setToolTip(tr("Import the calibration of the cameras from a file of Dewpoint or another "
                       "program"));
  refresh();
}

int CameraPanel::chosen() const {
  const int count = static_cast<int>(document_.project().cameras.size());
  return std::min(std::max(0, selection_.camera()), count - 1);
}

void CameraPanel::refresh() {
  list_->setCurrentIndex(list_->model()->index(chosen(), 0));
  showChosen();
}

void CameraPanel::showChosen() {
  const auto& cameras = document_.project().cameras;
  const int row = chosen();
  const bool any = row >= 0 && row < static_cast<int>(cameras.size());
  const ProjectCamera camera = any ? cameras[static_cast<std::size_t>(row)] : ProjectCamera();
  const bool own = any && camera.source != SourceKind::Simulation; // a scene brings its own
  const bool isFile = camera.source == SourceKind::Video || camera.source == SourceKind::Images;
  for (QWidget* field : std::initializer_list<QWidget*>{name_, source_, rotation_, mirror_, delay_,
                                                        backgroundImage_, backgroundImageBrowse_}) {
    field->setEnabled(own);
  }
  browse_->setEnabled(own && isFile);
  load_->setEnabled(any);
  delayEstimate_->setEditable(own);
  showDelayEstimate();
  updateTakeButton();
  backgroundImage_->setText(QString::fromStdString(camera.backgroundImageFile));
  name_->setText(QString::fromStdString(camera.camera.name));
  source_->setText(any && !own ? tr("simulated") : QString::fromStdString(camera.location));
  rotation_->setCurrentIndex(rotation_->findData(camera.rotateDegrees));
  mirror_->setChecked(camera.isMirrored);
  showValue(*delay_, inMilliseconds(camera.delay));
  any ? showCalibration(camera) : calibration_->clear();
}

void CameraPanel::showCalibration(const ProjectCamera& camera) {
  const auto coordinate = [](double meters) {
    return lengthNumber(meters, LengthScale::Meters, 3, NumberForm::Rounded);
  };
  const Intrinsics& in = camera.camera.intrinsics;
  const Eigen::Vector3d place = camera.camera.center();
  calibration_->setText(
      tr("%1 × %2 pixels, focal length %3 pixels\nPosition x, y, z: %4, %5, %6")
          .arg(in.width)
          .arg(in.height)
          .arg(numberText(in.focalX, 1, NumberForm::Rounded), coordinate(place.x()),
               coordinate(place.y()),
               lengthText(place.z(), LengthScale::Meters, 3, NumberForm::Rounded)));
}

void CameraPanel::edit(const QString& step, const std::function<void(ProjectCamera&)>& change) {
  const int row = chosen();
  if (row < 0) {
    return;
  }
  const auto edited = document_.editSources(
      step, [&](Project& project) { change(project.cameras[static_cast<std::size_t>(row)]); });
  if (!edited) {
    showChosen(); // refused: show what holds
  }
}

void CameraPanel::orient(const QString& step, int rotateDegrees, bool mirrored) {
  const int row = chosen();
  if (row < 0) {
    return;
  }
  const auto edited = document_.editSources(step, [&](Project& project) {
    project = withImageOrientation(std::move(project), static_cast<std::size_t>(row), rotateDegrees,
                                   mirrored);
  });
  if (!edited) {
    showChosen();
  }
}

void CameraPanel::relocate() {
  const int row = chosen();
  if (row < 0) {
    return;
  }
  const ProjectCamera& camera = document_.project().cameras[static_cast<std::size_t>(row)];
  const QString old = QString::fromStdString(camera.location);
  const QString file =
      camera.source == SourceKind::Images
          ? QFileDialog::getExistingDirectory(this, tr("Choose a folder of images"), old)
          : QFileDialog::getOpenFileName(this, tr("Choose the video for this camera"), old);
  if (!file.isEmpty()) {
    edit(tr("Change image source"),
         [&](ProjectCamera& changed) { changed.location = file.toStdString(); });
  }
}

void CameraPanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  taker_->setSnapshot(snapshot);
  updateTakeButton();
  clocks_ = snapshot ? snapshot->clocks : std::vector<ClockEstimate>();
  showDelayEstimate();
}

void CameraPanel::showDelayEstimate() {
  const auto row = static_cast<std::size_t>(std::max(0, chosen()));
  const auto& cameras = document_.project().cameras;
  delayEstimate_->setEstimate(row < clocks_.size() ? std::optional(clocks_[row]) : std::nullopt,
                              cameras.empty() ? QString()
                                              : QString::fromStdString(cameras[0].camera.name));
}

void CameraPanel::updateTakeButton() {
  backgroundImageTake_->setEnabled(source_->isEnabled() && taker_->canCapture(chosen()));
}

void CameraPanel::setBackgroundImage(const QString& file) {
  edit(tr("Change background image"),
       [&](ProjectCamera& camera) { camera.backgroundImageFile = file.toStdString(); });
}

void CameraPanel::chooseBackgroundImage() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Choose a background image or video"),
                                                    backgroundImage_->text());
  if (!file.isEmpty()) {
    setBackgroundImage(file);
  }
}

} // namespace dewpoint::ui

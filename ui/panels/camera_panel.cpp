// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/camera_panel.h"

#include "core/base/angle.h"
#include "core/base/units.h"
#include "core/project/project.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/panels/background_image_taker.h"
#include "ui/selection/selection.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/file_choice.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/path_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

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
      emptyRoomLabel_(new QLabel(this)), emptyRoom_(new PathField(this)),
      emptyRoomBrowse_(new QPushButton(this)), emptyRoomTake_(new QPushButton(this)),
      turnLabel_(new QLabel(this)), turn_(new QComboBox(this)), mirror_(new QCheckBox(this)),
      lateLabel_(new QLabel(this)),
      late_(makeNumberField(QStringLiteral("cameraLate"), {-kMostLate, kMostLate, 1.0, 1}, this)),
      calibration_(new QLabel(this)), load_(new QPushButton(this)),
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
  emptyRoom_->setObjectName(QStringLiteral("cameraEmptyRoom"));
  emptyRoomBrowse_->setObjectName(QStringLiteral("cameraEmptyRoomBrowse"));
  emptyRoomTake_->setObjectName(QStringLiteral("cameraEmptyRoomTake"));
  turn_->setObjectName(QStringLiteral("cameraTurn"));
  mirror_->setObjectName(QStringLiteral("cameraMirror"));
  load_->setObjectName(QStringLiteral("cameraLoadCalibration"));
  calibration_->setObjectName(QStringLiteral("cameraCalibration"));
  calibration_->setWordWrap(true);
  calibration_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  for (const int degrees : {0, 90, 180, 270}) {
    turn_->addItem(angleText(degrees * base::kDegree, 0), degrees);
  }
  nameLabel_->setBuddy(name_);
  sourceLabel_->setBuddy(source_);
  turnLabel_->setBuddy(turn_);
  emptyRoomLabel_->setBuddy(emptyRoom_);
  lateLabel_->setBuddy(late_);
  auto* form = new QFormLayout;
  form->setSpacing(8);
  form->addRow(nameLabel_, name_);
  form->addRow(sourceLabel_, source_);
  form->addRow(nullptr, browse_);
  form->addRow(turnLabel_, turn_);
  form->addRow(nullptr, mirror_);
  form->addRow(lateLabel_, late_);
  form->addRow(emptyRoomLabel_, emptyRoom_);
  auto* rooms = new QHBoxLayout;
  rooms->setSpacing(8);
  rooms->addWidget(emptyRoomBrowse_);
  rooms->addWidget(emptyRoomTake_, 1);
  form->addRow(nullptr, rooms);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(list_, 1);
  column->addLayout(form);
  column->addWidget(calibration_);
  column->addWidget(load_);
}

void CameraPanel::connectFields() {
  connect(&document_, &Document::replaced, this, &CameraPanel::refresh);
  connect(&document_, &Document::sourcesChanged, this, &CameraPanel::refresh);
  connect(&document_, &Document::calibrationChanged, this, &CameraPanel::showChosen);
  connect(&document_, &Document::emptyRoomsChanged, this, &CameraPanel::showChosen);
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
    edit(tr("Change source of images"), [this](ProjectCamera& camera) {
      camera.location = source_->text().trimmed().toStdString();
    });
  });
  connect(turn_, &QComboBox::activated, this, [this](int index) {
    edit(tr("Rotate images"),
         [&](ProjectCamera& camera) { camera.rotateDegrees = turn_->itemData(index).toInt(); });
  });
  connect(mirror_, &QCheckBox::clicked, this, [this](bool mirrored) {
    edit(tr("Mirror images"), [&](ProjectCamera& camera) { camera.mirrored = mirrored; });
  });
  connect(late_, &QDoubleSpinBox::editingFinished, this, [this] {
    edit(tr("Change delay"), [this](ProjectCamera& camera) {
      const double shown = std::round(inMilliseconds(camera.delay) * kLateSteps) / kLateSteps;
      if (late_->value() != shown) { // what is not shown of it must not be lost
        camera.delay = fromMilliseconds(late_->value());
      }
    });
  });
  connect(browse_, &QPushButton::clicked, this, &CameraPanel::relocate);
  connect(emptyRoom_, &QLineEdit::editingFinished, this,
          [this] { setEmptyRoom(emptyRoom_->text().trimmed()); });
  connect(emptyRoomBrowse_, &QPushButton::clicked, this, &CameraPanel::chooseEmptyRoom);
  connect(emptyRoomTake_, &QPushButton::clicked, this, [this] { taker_->take(chosen()); });
  connect(taker_, &BackgroundImageTaker::busyChanged, this, &CameraPanel::enableTake);
  connect(load_, &QPushButton::clicked, this, [this] {
    const QString file =
        askForFile(this, tr("Choose a calibration"), tr("Calibrations (*.toml);;All files (*)"));
    if (!file.isEmpty()) {
      Q_EMIT calibrationWanted(file);
    }
  });
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
  turnLabel_->setText(tr("Rotated"));
  turn_->setToolTip(tr("Clockwise rotation of the images before use"));
  mirror_->setText(tr("Mirrored"));
  mirror_->setToolTip(tr("Mirror the images left to right, after rotation"));
  lateLabel_->setText(tr("Delay"));
  late_->setSuffix(tr(" ms"));
  late_->setToolTip(tr("Delay of this camera's images in ms, used to synchronize it with the other "
                       "cameras. Calibration with a wand can measure the delay"));
  late_->setAccessibleName(tr("Delay of the images in milliseconds"));
  emptyRoomLabel_->setText(tr("Background image"));
  emptyRoom_->setToolTip(
      tr("Image, video or image folder that shows the scene without any target. Regions that have "
         "the target's color there are not taken for the target"));
  emptyRoomBrowse_->setText(tr("Choose…"));
  emptyRoomBrowse_->setAccessibleName(tr("Choose background image"));
  emptyRoomBrowse_->setToolTip(tr("Find an image or a video of the scene without any target"));
  emptyRoomTake_->setText(tr("Use current image"));
  emptyRoomTake_->setToolTip(tr("Save the current image of this camera as its background image"));
  load_->setText(tr("Load calibration…"));
  load_->setToolTip(tr("Load the calibration of all cameras from a file"));
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
  for (QWidget* field : std::initializer_list<QWidget*>{name_, source_, turn_, mirror_, late_,
                                                        load_, emptyRoom_, emptyRoomBrowse_}) {
    field->setEnabled(own);
  }
  browse_->setEnabled(own && isFile);
  enableTake();
  emptyRoom_->setText(QString::fromStdString(camera.backgroundImage));
  name_->setText(QString::fromStdString(camera.camera.name));
  source_->setText(any && !own ? tr("simulated") : QString::fromStdString(camera.location));
  turn_->setCurrentIndex(turn_->findData(camera.rotateDegrees));
  mirror_->setChecked(camera.mirrored);
  showValue(*late_, inMilliseconds(camera.delay));
  any ? showCalibration(camera) : calibration_->clear();
}

void CameraPanel::showCalibration(const ProjectCamera& camera) {
  const auto coordinate = [](double meters) {
    return lengthNumber(meters, LengthScale::Meters, 3, NumberForm::Rounded);
  };
  const Intrinsics& in = camera.camera.intrinsics;
  const Eigen::Vector3d place = camera.camera.center();
  calibration_->setText(
      tr("%1 × %2 pixels, focal length %3 pixels\nat %4, %5, %6")
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
  const auto edited = document_.edit(
      step, [&](Project& project) { change(project.cameras[static_cast<std::size_t>(row)]); });
  if (!edited) {
    showChosen(); // refused: show what holds
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
    edit(tr("Change source of images"),
         [&](ProjectCamera& changed) { changed.location = file.toStdString(); });
  }
}

void CameraPanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  taker_->setSnapshot(snapshot);
  enableTake();
}

void CameraPanel::enableTake() {
  emptyRoomTake_->setEnabled(source_->isEnabled() && taker_->canTake(chosen()));
}

void CameraPanel::setEmptyRoom(const QString& file) {
  edit(tr("Change background image"),
       [&](ProjectCamera& camera) { camera.backgroundImage = file.toStdString(); });
}

void CameraPanel::chooseEmptyRoom() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Choose a background image or video"),
                                                    emptyRoom_->text());
  if (!file.isEmpty()) {
    setEmptyRoom(file);
  }
}

} // namespace dewpoint::ui

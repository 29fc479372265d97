// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/project_pane.h"

#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "core/setup/new_project/new_project.h"
#include "core/setup/new_project/project_cameras.h"
#include "core/setup/new_project/project_devices.h"
#include "ui/cameras/camera_device_text.h"
#include "ui/cameras/camera_edits.h"
#include "ui/cameras/camera_icon_model.h"
#include "ui/cameras/color_locker.h"
#include "ui/cameras/control_form.h"
#include "ui/cameras/control_sync.h"
#include "ui/cameras/crop_form.h"
#include "ui/cameras/device_watch.h"
#include "ui/cameras/exposure_view.h"
#include "ui/cameras/format_choice.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/style/image.h"
#include "ui/style/spacing.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/choice_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kControlsHeight = 160; ///< pixels; chosen: five controls at once

} // namespace

ProjectPane::ProjectPane(const Workbench& bench, const CameraParts& parts, QWidget* parent)
    : QWidget(parent), bench_(bench), parts_(parts),
      icons_(new CameraIconModel(bench.cameras, this)), title_(new QLabel(this)),
      list_(new QListView(this)), remove_(new QPushButton(this)), exchange_(new QPushButton(this)),
      nameLabel_(new QLabel(this)), name_(new QLineEdit(this)), source_(new QLabel(this)),
      rotationLabel_(new QLabel(this)), rotation_(new QComboBox(this)),
      mirror_(new QCheckBox(this)), cropLabel_(new QLabel(this)), crop_(new CropForm(this)),
      notes_(new QLabel(this)), exposure_(new ExposureView(bench.cameras, this)),
      deviceBox_(new QWidget(this)), format_(new FormatChoice(deviceBox_)),
      controls_(new ControlForm(deviceBox_)), controlArea_(new QScrollArea(deviceBox_)),
      controlNote_(new QLabel(deviceBox_)), lock_(new QPushButton(deviceBox_)),
      lockAll_(new QPushButton(deviceBox_)) {
  for (const auto& [widget, name] : std::initializer_list<std::pair<QWidget*, const char*>>{
           {list_, "projectCameras"},
           {remove_, "projectCameraRemove"},
           {exchange_, "projectCameraExchange"},
           {name_, "projectCameraName"},
           {source_, "projectCameraSource"},
           {rotation_, "projectCameraRotation"},
           {mirror_, "projectCameraMirror"},
           {crop_, "projectCameraCrop"},
           {notes_, "projectCameraNotes"},
           {deviceBox_, "projectCameraDevice"},
           {lock_, "projectCameraLock"},
           {lockAll_, "projectCameraLockAll"}}) {
    widget->setObjectName(QLatin1String(name));
  }
  arrange();
  onRetranslate(this, [this] { retranslateUi(); });
  connectParts();
}

void ProjectPane::arrange() {
  list_->setModel(icons_);
  list_->setIconSize(kCameraIconSize);
  list_->setSpacing(2);
  list_->setUniformItemSizes(true);
  exchange_->setMenu(new QMenu(exchange_));
  addRotationChoices(*rotation_);
  nameLabel_->setBuddy(name_);
  rotationLabel_->setBuddy(rotation_);
  source_->setWordWrap(true);
  source_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  notes_->setWordWrap(true);
  controlNote_->setWordWrap(true);
  controlArea_->setWidget(controls_);
  controlArea_->setWidgetResizable(true);
  controlArea_->setFrameShape(QFrame::NoFrame);
  controlArea_->setMinimumHeight(kControlsHeight);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kSpacing);
  buttons->addWidget(remove_);
  buttons->addWidget(exchange_);
  buttons->addStretch(1);
  auto* orientation = new QHBoxLayout;
  orientation->setSpacing(kSpacing);
  orientation->addWidget(rotation_, 1);
  orientation->addWidget(mirror_);
  auto* form = new QFormLayout;
  form->setSpacing(kSpacing);
  form->addRow(nameLabel_, name_);
  form->addRow(rotationLabel_, orientation);
  form->addRow(cropLabel_, crop_);
  auto* locks = new QHBoxLayout;
  locks->setSpacing(kSpacing);
  locks->addWidget(lock_);
  locks->addWidget(lockAll_);
  locks->addStretch(1);
  auto* device = new QVBoxLayout(deviceBox_);
  device->setContentsMargins(0, 0, 0, 0);
  device->setSpacing(kSpacing);
  device->addWidget(format_);
  device->addWidget(controlNote_);
  device->addWidget(controlArea_, 1);
  device->addLayout(locks);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSpacing);
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  column->addWidget(title_);
  column->addWidget(list_, 1);
  column->addLayout(buttons);
  column->addWidget(source_);
  column->addLayout(form);
  column->addWidget(notes_);
  column->addWidget(exposure_);
  column->addWidget(deviceBox_, 1);
}

void ProjectPane::connectParts() {
  connect(&bench_.document, &Document::projectReplaced, this, &ProjectPane::refresh);
  connect(&bench_.document, &Document::changed, this, &ProjectPane::refresh);
  connect(&bench_.selection, &Selection::cameraSelected, this, &ProjectPane::refresh);
  connect(&parts_.watch, &DeviceWatch::changed, this, &ProjectPane::refresh);
  connect(&parts_.controls, &ControlSync::controlsWritten, this, &ProjectPane::readControls);
  connect(&parts_.locker, &ColorLocker::completed, this, &ProjectPane::readControls);
  connect(&parts_.locker, &ColorLocker::busyChanged, this, &ProjectPane::refresh);
  connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (current.isValid()) {
              bench_.selection.selectCamera(current.row());
            }
          });
  connect(remove_, &QPushButton::clicked, this, [this] { parts_.edits.remove(camera()); });
  connect(exchange_->menu(), &QMenu::aboutToShow, this, &ProjectPane::fillExchange);
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    if (name_->isModified() && camera() >= 0) {
      name_->setModified(false);
      parts_.edits.rename(camera(), name_->text());
      refresh(); // a name that was refused is not shown
    }
  });
  const auto orient = [this] {
    parts_.edits.setOrientation(camera(), rotation_->currentData().toInt(), mirror_->isChecked());
  };
  connect(rotation_, &QComboBox::activated, this, orient);
  connect(mirror_, &QCheckBox::clicked, this, orient);
  connect(crop_, &CropForm::changed, this, [this](int camera, const ImageMargins& margins) {
    parts_.edits.crop(camera, margins);
    refresh(); // margins that were refused are not shown
  });
  connect(format_, &FormatChoice::formatChosen, this, [this](const capture::DeviceFormat& format) {
    parts_.edits.setFormats({{camera(), format}});
  });
  connect(controls_, &ControlForm::changed, this, [this](const std::string& name, qint64 value) {
    parts_.edits.setControl(camera(), name, value);
  });
  connect(controls_, &ControlForm::dragEnded, &bench_.document, &Document::endStepMerging);
  connect(lock_, &QPushButton::clicked, this, [this] { parts_.locker.lockColors(camera()); });
  connect(lockAll_, &QPushButton::clicked, this, [this] { parts_.locker.lockColors(-1); });
}

void ProjectPane::retranslateUi() {
  title_->setText(tr("Cameras of the project"));
  list_->setAccessibleName(title_->text());
  remove_->setText(tr("Remove"));
  exchange_->setText(tr("Exchange with"));
  exchange_->setToolTip(
      tr("Exchange the image source with that of another camera, for example after the cables were "
         "exchanged. The cameras keep their names and calibrations"));
  nameLabel_->setText(tr("Name"));
  name_->setToolTip(tr("Name of the camera, in views and files"));
  rotationLabel_->setText(tr("Rotated"));
  rotation_->setToolTip(
      tr("Clockwise rotation of the images before use. The calibration is rotated with them"));
  mirror_->setText(tr("Mirrored"));
  mirror_->setToolTip(tr("Mirror the images left to right, after rotation"));
  cropLabel_->setText(tr("Cropped"));
  lock_->setText(tr("Lock colors"));
  lock_->setToolTip(tr("Switch off the automatic exposure, gain and white balance of this camera, "
                       "and keep the current values"));
  lockAll_->setText(tr("Lock all cameras"));
  lockAll_->setToolTip(tr("Switch off the automatic exposure, gain and white balance of all "
                          "connected cameras, and keep the current values"));
  refresh();
}

int ProjectPane::camera() const {
  const int count = static_cast<int>(bench_.document.project().cameras.size());
  return std::min(std::max(0, bench_.selection.camera()), count - 1);
}

std::optional<std::size_t> ProjectPane::device() const {
  const auto matches = matchProjectDevices(bench_.document.project(), parts_.watch.devices());
  const auto row = static_cast<std::size_t>(camera());
  return camera() >= 0 && row < matches.size() ? matches[row].deviceIndex : std::nullopt;
}

void ProjectPane::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
}

void ProjectPane::showImages() {
  const TrackSnapshotPtr filled = bench_.session.withMissingImagesFilled(snapshot_);
  std::vector<QIcon> icons;
  const auto count = bench_.document.project().cameras.size();
  for (std::size_t k = 0; k < count; ++k) {
    const bool has = filled && filled->frames && k < filled->frames->frames.size() &&
                     filled->frames->frames[k] != nullptr;
    icons.push_back(cameraIcon(has ? toQImage(filled->frames->frames[k]->image) : QImage(),
                               palette(), devicePixelRatioF()));
  }
  icons_->setIcons(std::move(icons));
  exposure_->setSnapshot(snapshot_); // an image is not measured again in later frames
}

void ProjectPane::refresh() {
  const Project& project = bench_.document.project();
  const int row = camera();
  list_->setCurrentIndex(icons_->index(row, 0));
  exposure_->setCamera(row);
  const ProjectCamera shown =
      row >= 0 ? project.cameras[static_cast<std::size_t>(row)] : ProjectCamera();
  const bool own = row >= 0 && shown.source != SourceKind::Simulation;
  const bool several = project.cameras.size() > 1;
  remove_->setEnabled(own && several);
  remove_->setToolTip(several ? tr("Remove this camera. Undo restores it with its calibration")
                              : tr("A project needs at least one camera"));
  exchange_->setEnabled(own && several);
  for (QWidget* field : std::initializer_list<QWidget*>{name_, rotation_, mirror_, crop_}) {
    field->setEnabled(own);
  }
  if (!name_->isModified()) {
    name_->setText(QString::fromStdString(shown.camera.name));
  }
  rotation_->setCurrentIndex(rotation_->findData(shown.rotateDegrees));
  mirror_->setChecked(shown.isMirrored);
  const Intrinsics& lens = shown.camera.intrinsics;
  crop_->setMargins(row, shown.crop, lens.width + shown.crop.width(),
                    lens.height + shown.crop.height());
  const bool isDevice = own && shown.source == SourceKind::Device;
  const bool isNamed = isDevice && !shown.device.identity.isEmpty();
  source_->setText(!own      ? tr("simulated")
                   : isNamed ? QString::fromStdString(describe(shown.device.identity))
                             : QString::fromStdString(shownLocation(shown.location)));
  const auto connected = device();
  deviceBox_->setVisible(isDevice);
  lock_->setEnabled(connected.has_value() && !parts_.locker.isBusy());
  lockAll_->setEnabled(lock_->isEnabled());
  format_->setEnabled(connected.has_value());
  format_->setFormats(connected ? parts_.watch.devices()[*connected].formats
                                : std::vector<capture::OfferedFormat>(),
                      shown.device.format);
  refreshNotes();
  const std::string path = connected ? parts_.watch.devices()[*connected].path : std::string();
  if (path != path_) {
    path_ = path;
    present_.clear();
    readControls();
  }
  showControls();
}

void ProjectPane::refreshNotes() {
  const Project& project = bench_.document.project();
  QStringList notes;
  if (!project.scene.empty()) {
    notes << tr("A simulated scene has its own cameras. They cannot be changed.");
  } else if (const int row = camera(); row >= 0) {
    const auto index = static_cast<std::size_t>(row);
    const ProjectCamera& shown = project.cameras[index];
    const auto matches = matchProjectDevices(project, parts_.watch.devices());
    if (shown.source == SourceKind::Device && parts_.watch.areDevicesListed() &&
        !matches[index].deviceIndex) {
      notes << (matches[index].isAmbiguous()
                    ? tr("▲ Several devices may be this camera. Choose one on the right.")
                    : tr("▲ This device is not connected."));
    }
    const capture::DeviceFormat& format = shown.device.format;
    const bool isUpright = shown.rotateDegrees % 180 == 0;
    const Intrinsics& lens = shown.camera.intrinsics;
    const int across = lens.width + shown.crop.width();
    const int down = lens.height + shown.crop.height();
    const int width = isUpright ? across : down;
    const int height = isUpright ? down : across;
    if (hasGuessedPose(project, index)) {
      notes << tr("This camera is not calibrated yet.");
    } else if (format.width > 0 && (format.width != width || format.height != height)) {
      notes << tr("▲ The calibration is for images of %1. Choose this size, or calibrate again.")
                   .arg(imageSizeText(width, height));
    }
  }
  notes_->setText(notes.join(QLatin1Char('\n')));
  notes_->setVisible(!notes.isEmpty());
}

void ProjectPane::readControls() {
  if (path_.empty()) {
    return;
  }
  job_.start([this, path = path_,
              access = parts_.watch.deviceAccess()](const BackgroundJob::Progress&) {
    auto controls =
        std::make_shared<Result<std::vector<capture::DeviceControl>>>(access->readControls(path));
    return [this, path, controls] {
      if (path != path_) {
        return;
      }
      controlNote_->setVisible(!*controls);
      if (*controls) {
        present_ = **controls;
        parts_.controls.rememberControls(path, present_);
      } else {
        present_.clear();
        controlNote_->setText(errorText(controls->error()));
      }
      showControls();
    };
  });
}

void ProjectPane::showControls() {
  std::vector<capture::DeviceControl> shown = present_;
  const int row = camera();
  if (row >= 0) {
    const auto& wanted =
        bench_.document.project().cameras[static_cast<std::size_t>(row)].device.controls;
    for (capture::DeviceControl& control : shown) {
      const auto found = wanted.find(control.name);
      if (found != wanted.end() && !control.isInactive) {
        control.value = found->second; // it is on its way to the device
      }
    }
  }
  controls_->setControls(shown);
}

void ProjectPane::fillExchange() {
  QMenu* menu = exchange_->menu();
  menu->clear();
  for (int k = 0; k < bench_.cameras.rowCount(); ++k) {
    if (k != camera()) {
      menu->addAction(bench_.cameras.nameOf(k), this,
                      [this, k] { parts_.edits.swapSources(camera(), k); });
    }
  }
}

} // namespace dewpoint::ui

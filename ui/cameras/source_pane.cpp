// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/source_pane.h"

#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "core/setup/new_project/project_devices.h"
#include "ui/cameras/address_form.h"
#include "ui/cameras/camera_device_text.h"
#include "ui/cameras/camera_edits.h"
#include "ui/cameras/camera_icon_model.h"
#include "ui/cameras/device_watch.h"
#include "ui/cameras/preview_streams.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/style/image.h"
#include "ui/style/spacing.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/file_choice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSet>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

QString previewLocation(const capture::CameraDevice& device) {
  return QString::fromStdString(device.stablePath.empty() ? device.path : device.stablePath);
}

} // namespace

SourcePane::SourcePane(const Workbench& bench, const CameraParts& parts,
                       std::function<int()> selected, QWidget* parent)
    : QWidget(parent), bench_(bench), parts_(parts), selected_(std::move(selected)),
      previews_(new PreviewStreams(this)), title_(new QLabel(this)), list_(new QListWidget(this)),
      empty_(new QLabel(this)), add_(new QPushButton(this)), use_(new QPushButton(this)),
      addressTitle_(new QLabel(this)), address_(new AddressForm(this)),
      recordingTitle_(new QLabel(this)), videos_(new QPushButton(this)),
      folder_(new QPushButton(this)), note_(new QLabel(this)) {
  list_->setObjectName(QStringLiteral("connectedDevices"));
  empty_->setObjectName(QStringLiteral("noDevices"));
  add_->setObjectName(QStringLiteral("deviceAdd"));
  use_->setObjectName(QStringLiteral("deviceUse"));
  videos_->setObjectName(QStringLiteral("camerasAddVideos"));
  folder_->setObjectName(QStringLiteral("camerasAddFolder"));
  note_->setObjectName(QStringLiteral("sourceNote"));
  arrange();
  onRetranslate(this, [this] { retranslateUi(); });
  connectParts();
}

void SourcePane::arrange() {
  list_->setIconSize(kCameraIconSize);
  list_->setSpacing(2);
  list_->setWordWrap(true);
  empty_->setWordWrap(true);
  note_->setWordWrap(true);
  const auto row = [](std::initializer_list<QPushButton*> buttons) {
    auto* layout = new QHBoxLayout;
    layout->setSpacing(kSpacing);
    for (QPushButton* button : buttons) {
      button->setAutoDefault(false);
      layout->addWidget(button);
    }
    layout->addStretch(1);
    return layout;
  };
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSpacing);
  column->addWidget(title_);
  column->addWidget(list_, 1);
  column->addWidget(empty_);
  column->addLayout(row({add_, use_}));
  column->addSpacing(kSpacing);
  column->addWidget(addressTitle_);
  column->addWidget(address_);
  column->addSpacing(kSpacing);
  column->addWidget(recordingTitle_);
  column->addLayout(row({videos_, folder_}));
  column->addWidget(note_);
  column->addStretch(0); // takes the room of the list while no device is connected
  for (QLabel* title : {title_, addressTitle_, recordingTitle_}) {
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
  }
}

void SourcePane::connectParts() {
  connect(&parts_.watch, &DeviceWatch::changed, this, &SourcePane::refresh);
  connect(&bench_.document, &Document::projectReplaced, this, &SourcePane::refresh);
  connect(&bench_.document, &Document::changed, this, &SourcePane::refresh);
  connect(&parts_.edits, &CameraEdits::busyChanged, this, &SourcePane::updateButtons);
  connect(&bench_.selection, &Selection::cameraSelected, this, &SourcePane::updateButtons);
  connect(list_, &QListWidget::itemSelectionChanged, this, &SourcePane::updateButtons);
  connect(list_, &QListWidget::itemDoubleClicked, add_, &QPushButton::click);
  connect(previews_, &PreviewStreams::changed, this, [this](const QString& location) {
    const auto& devices = parts_.watch.devices();
    for (std::size_t k = 0; k < devices.size(); ++k) {
      if (previewLocation(devices[k]) == location) {
        refreshRow(static_cast<int>(k));
      }
    }
  });
  connect(add_, &QPushButton::clicked, this, &SourcePane::addDevice);
  connect(use_, &QPushButton::clicked, this, &SourcePane::useDevice);
  connect(videos_, &QPushButton::clicked, this, &SourcePane::addVideos);
  connect(folder_, &QPushButton::clicked, this, &SourcePane::addFolder);
  connect(address_, &AddressForm::addRequested, this,
          [this](const QString& address, const QSize& size) {
            parts_.edits.addLocations({address}, size);
          });
  connect(address_, &AddressForm::replaceRequested, this,
          [this](const QString& address) { parts_.edits.replaceByLocation(selected_(), address); });
}

void SourcePane::retranslateUi() {
  title_->setText(tr("Connected to this computer"));
  list_->setAccessibleName(title_->text());
  empty_->setText(tr("No camera is connected. Plug one in: it appears here by itself."));
  add_->setText(tr("Add"));
  use_->setText(tr("Assign to selected camera"));
  addressTitle_->setText(tr("Network cameras, pipelines and test patterns"));
  recordingTitle_->setText(tr("Recordings"));
  videos_->setText(tr("Add videos…"));
  folder_->setText(tr("Add image folder…"));
  refresh();
}

std::optional<int> SourcePane::userOf(int device) const {
  const auto matches = matchProjectDevices(bench_.document.project(), parts_.watch.devices());
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (matches[k].deviceIndex == static_cast<std::size_t>(device)) {
      return static_cast<int>(k);
    }
  }
  return std::nullopt;
}

QString SourcePane::obstacle(SourceKind kind) const {
  const Project& project = bench_.document.project();
  if (checkCanAddCamera(project, kind)) {
    return {};
  }
  if (!project.scene.empty()) {
    return tr("A simulated scene has its own cameras. They cannot be changed.");
  }
  return comesFromRecording(kind)
             ? tr("This project has live cameras. Recordings need a project of their own.")
             : tr("This project has recordings. Live cameras need a project of their own.");
}

void SourcePane::refresh() {
  const auto& devices = parts_.watch.devices();
  const int count = static_cast<int>(devices.size());
  const int selected = list_->currentRow();
  while (list_->count() > count) {
    delete list_->takeItem(list_->count() - 1);
  }
  while (list_->count() < count) {
    list_->addItem(new QListWidgetItem);
  }
  for (int row = 0; row < count; ++row) {
    refreshRow(row);
  }
  list_->setCurrentRow(selected < 0 && count > 0 ? 0 : std::min(selected, count - 1));
  list_->setVisible(count > 0);
  empty_->setVisible(count == 0 && parts_.watch.areDevicesListed());
  const bool isScene = !bench_.document.project().scene.empty();
  const QString live = obstacle(SourceKind::Device);
  note_->setText(!live.isEmpty() ? live : isScene ? QString() : obstacle(SourceKind::Video));
  address_->setBlockedReason(live);
  updatePreviews();
  updateButtons();
}

void SourcePane::refreshRow(int row) {
  const capture::CameraDevice& device = parts_.watch.devices()[static_cast<std::size_t>(row)];
  QListWidgetItem* item = list_->item(row);
  const auto user = userOf(row);
  const PreviewState* preview = previews_->previewState(previewLocation(device));
  QStringList lines{deviceName(device), devicePortText(device)};
  if (user) {
    lines << tr("used by %1").arg(bench_.cameras.nameOf(*user));
  } else if (!device.problem.empty()) {
    lines << tr("✗ %1").arg(QString::fromStdString(device.problem));
  } else if (preview != nullptr && !preview->problem.isEmpty()) {
    lines << tr("✗ %1").arg(preview->problem);
  } else if (preview != nullptr && !preview->image.isNull()) {
    lines << imageFormatText(preview->size, preview->framesPerSecond);
  }
  lines << formatSummaryText(device);
  lines.removeAll(QString());
  item->setText(lines.join(QLatin1Char('\n')));
  item->setToolTip(formatDetailsText(device));
  if (!user) {
    item->setIcon(
        cameraIcon(preview != nullptr ? preview->image : QImage(), palette(), devicePixelRatioF()));
  }
}

void SourcePane::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
}

void SourcePane::showImages() {
  for (int row = 0; row < list_->count(); ++row) {
    const auto user = userOf(row);
    const auto camera = static_cast<std::size_t>(user.value_or(0));
    const bool has = user && snapshot_ && snapshot_->frames &&
                     camera < snapshot_->frames->frames.size() &&
                     snapshot_->frames->frames[camera] != nullptr;
    if (user) {
      list_->item(row)->setIcon(
          cameraIcon(has ? toQImage(snapshot_->frames->frames[camera]->image) : QImage(), palette(),
                     devicePixelRatioF()));
    }
  }
}

void SourcePane::setPreviewing(bool previewing) {
  previewing_ = previewing;
  updatePreviews();
}

void SourcePane::updatePreviews() {
  QSet<QString> locations;
  const auto& devices = parts_.watch.devices();
  for (int row = 0; previewing_ && row < static_cast<int>(devices.size()); ++row) {
    const capture::CameraDevice& device = devices[static_cast<std::size_t>(row)];
    if (device.problem.empty() && !userOf(row)) {
      locations.insert(previewLocation(device)); // one that is in use cannot be opened twice
    }
  }
  previews_->setLocations(locations);
}

void SourcePane::updateButtons() {
  const int row = list_->currentRow();
  const QString live = obstacle(SourceKind::Device);
  const QString recorded = obstacle(SourceKind::Video);
  const auto user = row >= 0 ? userOf(row) : std::nullopt;
  const bool any = row >= 0 && live.isEmpty() && !parts_.edits.isBusy();
  add_->setEnabled(any && !user);
  add_->setToolTip(!live.isEmpty() ? live
                   : user          ? tr("The project uses this device already")
                                   : tr("Add the device as a new camera of the project"));
  use_->setEnabled(any && selected_() >= 0 && user != selected_());
  use_->setToolTip(!live.isEmpty() ? live
                   : user
                       ? tr("Exchange the devices of this camera and of the selected camera")
                       : tr("Make this device the image source of the selected camera. The camera "
                            "keeps its name and its calibration"));
  for (QPushButton* button : {videos_, folder_}) {
    button->setEnabled(recorded.isEmpty() && !parts_.edits.isBusy());
  }
  videos_->setToolTip(recorded.isEmpty() ? tr("Video files, one per camera") : recorded);
  folder_->setToolTip(recorded.isEmpty() ? tr("A folder of images, one per frame") : recorded);
}

void SourcePane::addDevice() {
  const int row = list_->currentRow();
  if (row >= 0 && !userOf(row)) {
    const auto source = sourceOf(parts_.watch.devices()[static_cast<std::size_t>(row)]);
    parts_.edits.add({source});
  }
}

void SourcePane::useDevice() {
  const int row = list_->currentRow();
  if (row < 0 || selected_() < 0) {
    return;
  }
  if (const auto user = userOf(row)) {
    parts_.edits.swapSources(selected_(), *user);
  } else {
    parts_.edits.replace(selected_(),
                         sourceOf(parts_.watch.devices()[static_cast<std::size_t>(row)]));
  }
}

void SourcePane::addVideos() {
  parts_.edits.addLocations(askForFiles(
      this, tr("Choose one video per camera"),
      tr("Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)")));
}

void SourcePane::addFolder() {
  const QString folder = askForFolder(this, tr("Choose a folder of images"));
  if (!folder.isEmpty()) {
    parts_.edits.addLocations({folder});
  }
}

} // namespace dewpoint::ui

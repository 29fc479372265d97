// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/new_project_page.h"

#include "core/setup/calibration/calibration_check.h"
#include "core/setup/calibration/calibration_exchange.h"
#include "core/setup/device_list.h"
#include "core/setup/new_project/footage.h"
#include "ui/start/calibration_choice.h"
#include "ui/start/drop_zone.h"
#include "ui/style/spacing.h"
#include "ui/style/theme.h"
#include "ui/text/calibration_files.h"
#include "ui/text/camera_agreement_text.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/decimal_field.h"
#include "ui/widgets/file_choice.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kFormWidth = 960;     ///< pixels, at most; chosen
constexpr double kUsualRate = 30.0; ///< frames per second of image folders

std::vector<std::string> pathsOf(const std::vector<capture::CameraDevice>& devices) {
  std::vector<std::string> paths;
  std::ranges::transform(devices, std::back_inserter(paths), &capture::CameraDevice::path);
  return paths;
}

} // namespace

NewProjectPage::NewProjectPage(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), intro_(new QLabel(this)),
      name_(new QLineEdit(this)), nameLabel_(new QLabel(this)), list_(new QStackedWidget(this)),
      cameras_(new CameraTable(this)), dropZone_(new DropZone(this)), note_(new QLabel(this)),
      calibration_(new CalibrationChoice(this)), rateLabel_(new QLabel(this)),
      rate_(new DecimalField(this)), buttons_(new QDialogButtonBox(this)),
      searches_(std::make_unique<JobQueue>()) {
  setObjectName(QStringLiteral("newProjectPage"));
  QFont big = title_->font();
  big.setPointSizeF(big.pointSizeF() * 1.6);
  big.setWeight(QFont::DemiBold);
  title_->setFont(big);
  intro_->setWordWrap(true);
  name_->setObjectName(QStringLiteral("newName"));
  nameLabel_->setBuddy(name_);
  note_->setObjectName(QStringLiteral("newFootageNote"));
  note_->setWordWrap(true);
  rate_->setObjectName(QStringLiteral("newRate"));
  rate_->setRange(0.1, 10000.0);
  rate_->setValue(kUsualRate);
  rateLabel_->setBuddy(rate_);
  list_->addWidget(dropZone_);
  list_->addWidget(cameras_);
  connect(dropZone_, &QToolButton::clicked, this, &NewProjectPage::chooseVideos);
  connect(cameras_, &CameraTable::changed, this, &NewProjectPage::refresh);
  makeButtons();
  arrange();
  onRetranslate(this, [this] { retranslateUi(); });
  refresh();
}

QPushButton* NewProjectPage::addButton(const char* name, const std::function<void()>& act) {
  auto* button = new QPushButton(this);
  button->setObjectName(QLatin1String(name));
  connect(button, &QPushButton::clicked, this, act);
  return button;
}

void NewProjectPage::makeButtons() {
  addVideos_ = addButton("newAddVideos", [this] { chooseVideos(); });
  addFolder_ = addButton("newAddFolder", [this] { chooseFolder(); });
  addDevices_ = addButton("newAddDevices", [this] { addConnectedCameras(); });
  addAddress_ = addButton("newAddAddress", [this] { cameras_->addAddressRow(); });
  remove_ = addButton("newRemove", [this] {
    cameras_->removeSelectedRows();
    findCalibration(); // of those that are left
  });
  create_ = addButton("newCreate", [this] { createProject(); });
  create_->setDefault(true);
  cancel_ = addButton("newCancel", [this] {
    cancelWork();
    Q_EMIT canceled();
  });
  buttons_->layout()->setSpacing(kSpacing);
  buttons_->addButton(create_, QDialogButtonBox::AcceptRole);
  buttons_->addButton(cancel_, QDialogButtonBox::RejectRole);
}

void NewProjectPage::arrange() {
  const auto row = [](std::initializer_list<QWidget*> widgets, int stretched) {
    auto* layout = new QHBoxLayout;
    layout->setSpacing(kSpacing);
    int index = 0;
    for (QWidget* widget : widgets) {
      layout->addWidget(widget, index++ == stretched ? 1 : 0);
    }
    if (stretched < 0) {
      layout->addStretch(1);
    }
    return layout;
  };
  auto* middle = new QWidget(this);
  middle->setMaximumWidth(kFormWidth);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSpacing);
  column->addWidget(title_);
  column->addWidget(intro_);
  column->addSpacing(kSpacing);
  column->addLayout(row({addVideos_, addFolder_, addDevices_, addAddress_, remove_}, -1));
  column->addWidget(list_, 1);
  column->addWidget(note_);
  column->addLayout(row({rateLabel_, rate_}, -1));
  column->addSpacing(kSpacing);
  column->addWidget(calibration_);
  column->addSpacing(kSpacing);
  column->addLayout(row({nameLabel_, name_}, 1));
  column->addSpacing(kSpacing);
  column->addWidget(buttons_);
  auto* all = new QHBoxLayout(this);
  all->setContentsMargins(32, 24, 32, 24);
  all->addStretch(1);
  all->addWidget(middle, 100);
  all->addStretch(1);
}

void NewProjectPage::retranslateUi() {
  const auto button = [](QPushButton* which, const QString& text, const QString& hint) {
    which->setText(text);
    which->setToolTip(hint);
  };
  title_->setText(tr("New project"));
  intro_->setText(tr("One row per camera. The videos must be synchronized: frame N must show the "
                     "same time in all of them."));
  button(addVideos_, tr("Add videos…"), tr("Video files, one per camera"));
  button(addFolder_, tr("Add image folder…"), tr("A folder of images, one per frame"));
  button(addDevices_, tr("Add connected cameras"), tr("All cameras connected to this computer"));
  button(addAddress_, tr("Add address"), tr("Enter a device number or a network stream"));
  button(remove_, tr("Remove"), tr("Remove the selected cameras"));
  button(create_, tr("Create"), tr("Create the project and show its first images"));
  button(cancel_, tr("Cancel"), tr("Go back without creating a project"));
  nameLabel_->setText(tr("Name:"));
  name_->setPlaceholderText(tr("(folder name)"));
  name_->setToolTip(tr("Name of the project"));
  rateLabel_->setText(tr("Images per second:"));
  rate_->setToolTip(tr("Frame rate of image folders, 0.1 to 10,000 per second"));
  cameras_->setHorizontalHeaderLabels({tr("Camera"), tr("Images from"), tr("Found")});
  cameras_->setAccessibleName(tr("Cameras in the new project"));
  refresh();
}

void NewProjectPage::startNewProject(const QStringList& files, bool findsCalibration) {
  // Whichever of them the platform puts first.
  setTabOrder(calibration_->lastButtonInTabOrder(), name_);
  setTabOrder(name_, create_);
  setTabOrder(create_, cancel_);
  cancelWork();
  cameras_->clearTable();
  name_->clear();
  calibration_->startNewProject(findsCalibration);
  refresh();
  addFiles(files);
  addVideos_->setFocus();
}

std::vector<FootageLocation>
NewProjectPage::locationsOf(const std::vector<std::string>& locations) {
  std::vector<FootageLocation> places;
  for (const std::string& location : locations) {
    const QString file = QString::fromStdString(location);
    places.push_back({location, canBeImageSource(location),
                      QFileInfo::exists(file) && !file.startsWith(QStringLiteral("/dev/")),
                      guessSourceKind(location) == SourceKind::Images});
  }
  return places;
}

void NewProjectPage::search(std::function<std::vector<FootageLocation>()> look,
                            std::function<void(const std::vector<FootageLocation>&)> found) {
  ++pendingSearches_;
  refresh();
  searches_->add([this, look = std::move(look), found = std::move(found)] {
    return [this, found, places = look()] {
      --pendingSearches_;
      found(places);
      refresh();
    };
  });
}

void NewProjectPage::cancelWork() {
  making_.cancel();
  searches_ = std::make_unique<JobQueue>();
  pendingSearches_ = 0;
}

void NewProjectPage::addFiles(const QStringList& files) {
  std::vector<std::string> names;
  std::ranges::transform(files, std::back_inserter(names), &QString::toStdString);
  std::vector<std::string> footage;
  for (const std::string& name : sortedInNaturalOrder(std::move(names))) {
    const QString file = QString::fromStdString(name);
    if (hasCalibrationSuffix(file)) {
      calibration_->setFile(file);
    } else {
      footage.push_back(name);
    }
  }
  if (!footage.empty()) {
    search([footage] { return locationsOf(footage); },
           [this](const std::vector<FootageLocation>& places) { addFootage(places); });
  }
}

void NewProjectPage::addFootage(const std::vector<FootageLocation>& places) {
  QStringList refused;
  bool hasFiles = false;
  for (const FootageLocation& place : places) {
    const QString file = QString::fromStdString(place.location);
    if (!place.canBeImageSource) {
      refused << QFileInfo(file).fileName();
    } else if (!cameras_->isListed(file)) { // dropped twice it is still one camera
      cameras_->addFootage(place);
      hasFiles = hasFiles || place.isFile;
    }
  }
  if (hasFiles) {
    findCalibration();
  }
  if (!refused.isEmpty()) {
    Q_EMIT failed(
        tr("Not a video, image or calibration file: %1.").arg(refused.join(QStringLiteral(", "))));
  }
}

void NewProjectPage::findCalibration() {
  if (!calibration_->acceptsProposals()) {
    return;
  }
  std::vector<std::string> recordings;
  std::vector<std::string> names;
  for (const NewCamera& camera : cameras_->cameras()) {
    recordings.push_back(camera.location);
    names.push_back(camera.name);
  }
  ++pendingSearches_; // nothing is created without a calibration that is about to be found
  refresh();
  searches_->add([this, recordings = std::move(recordings), names = std::move(names)] {
    return [this, found = calibrationFileBeside(recordings, names)] {
      --pendingSearches_;
      calibration_->proposeFile(found ? QString::fromStdString(found->string()) : QString());
      refresh();
    };
  });
}

void NewProjectPage::chooseVideos() {
  const QStringList files = askForFiles(
      this, tr("Choose one video per camera"),
      tr("Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)"));
  addFiles(files);
}

void NewProjectPage::chooseFolder() {
  const QString folder = askForFolder(this, tr("Choose a folder of images"));
  if (!folder.isEmpty()) {
    search([folder] { return locationsOf({folder.toStdString()}); },
           [this](const std::vector<FootageLocation>& places) {
             cameras_->addFootage(places.front());
             findCalibration();
           });
  }
}

void NewProjectPage::addConnectedCameras() {
  search([devices = devices_] { return locationsOf(pathsOf(devices->listDevices())); },
         [this](const std::vector<FootageLocation>& devices) {
           std::ranges::for_each(
               devices, [this](const FootageLocation& device) { cameras_->addFootage(device); });
           if (devices.empty()) {
             Q_EMIT failed(tr("No camera is connected to this computer. A network camera can be "
                              "added by its address."));
           }
         });
}

void NewProjectPage::refresh() {
  const bool any = cameras_->rowCount() > 0;
  list_->setCurrentWidget(any ? static_cast<QWidget*>(cameras_) : dropZone_);
  rateLabel_->setVisible(cameras_->hasImageFolders());
  rate_->setVisible(cameras_->hasImageFolders());
  remove_->setEnabled(cameras_->hasSelection());
  create_->setEnabled(any && pendingSearches_ == 0);
  const QString note = cameras_->recordingMismatchText();
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText, trackingStateColor(TrackingState::Searching, palette()));
  note_->setPalette(colors);
  std::vector<std::string> names;
  for (const NewCamera& camera : cameras_->cameras()) {
    names.push_back(camera.name);
  }
  calibration_->setCameraNames(std::move(names));
}

NewProject NewProjectPage::newProject() const {
  NewProject wanted;
  wanted.name = name_->text().toStdString();
  wanted.cameras = cameras_->cameras();
  if (!calibration_->file().isEmpty()) {
    wanted.calibrationFile = calibration_->file().toStdString();
    wanted.adaptation = calibration_->adaptation();
  }
  wanted.framesPerSecond = rate_->value();
  return wanted;
}

void NewProjectPage::createProject() {
  create_->setEnabled(false);
  const auto create = [this, devices = devices_](NewProject wanted) {
    bool images = false;
    bool live = false;
    for (NewCamera& camera : wanted.cameras) {
      camera.sourceKind = guessSourceKind(camera.location);
      images = images || camera.sourceKind == SourceKind::Images;
      live = live || camera.sourceKind == SourceKind::Device;
    }
    wanted.framesPerSecond = images ? wanted.framesPerSecond : 0.0;
    auto result = std::make_shared<Result<CreatedProject>>(createNewProject(wanted));
    if (*result && live) { // its cameras are recognized wherever they are plugged in later
      identifyDevices((*result)->project, devices->listDevices());
    }
    return [this, result] { finish(*result); };
  };
  making_.start(
      [create, wanted = newProject()](const BackgroundJob::Progress&) { return create(wanted); });
}

void NewProjectPage::finish(const Result<CreatedProject>& result) {
  refresh();
  if (!result) {
    const ImportProblem asked = importProblem(result.error());
    if (asked.question == ImportQuestion::Fit) {
      calibration_->showImageChangeQuestion();
      Q_EMIT failed(tr("%1. Choose below how the images differ from those of the calibration.")
                        .arg(errorText(asked.error)));
      return;
    }
    if (asked.question == ImportQuestion::Names && calibration_->isNameQuestionShown()) {
      Q_EMIT failed(tr("%1. For each camera of the project, choose a camera of the file below.")
                        .arg(errorText(asked.error)));
      return;
    }
    Q_EMIT failed(asked.question == ImportQuestion::None
                      ? errorText(asked.error)
                      : tr("%1. Create the project without this file, then choose Calibration › "
                           "Import calibration.")
                            .arg(errorText(asked.error)));
    return;
  }
  QString note;
  if (result->wereCamerasMatchedByOrder) {
    note = tr("The calibration uses other camera names. The cameras were matched by order.");
  }
  QStringList names;
  for (const ProjectCamera& camera : result->project.cameras) {
    names << QString::fromStdString(camera.camera.name);
  }
  for (const std::string& decision : result->decisions) {
    note += (note.isEmpty() ? QString() : QStringLiteral(" ")) + QString::fromStdString(decision);
  }
  for (const CameraDisagreement& fault : result->likelyMistakes) {
    note += (note.isEmpty() ? QString() : QStringLiteral(" ")) +
            tr("Probably a mistake in the calibration: %1").arg(disagreementText(fault, names));
  }
  Q_EMIT created(result->project, note);
}

} // namespace dewpoint::ui

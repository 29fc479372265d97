// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/new_project_page.h"

#include "core/setup/footage.h"
#include "ui/style/spacing.h"
#include "ui/text/camera_names.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/decimal_field.h"
#include "ui/widgets/file_choice.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kFormWidth = 820;
constexpr double kUsualRate = 30.0; ///< frames per second of image folders

enum Column { kName, kSource };

} // namespace

NewProjectPage::NewProjectPage(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), lead_(new QLabel(this)),
      name_(new QLineEdit(this)), nameLabel_(new QLabel(this)), cameras_(new QTableWidget(this)),
      calibrationLabel_(new QLabel(this)), calibration_(new QLabel(this)),
      rateLabel_(new QLabel(this)), rate_(new DecimalField(this)),
      buttons_(new QDialogButtonBox(this)), searches_(std::make_unique<JobQueue>()) {
  setObjectName(QStringLiteral("newProjectPage"));
  QFont big = title_->font();
  big.setPointSizeF(big.pointSizeF() * 1.6);
  big.setWeight(QFont::DemiBold);
  title_->setFont(big);
  name_->setObjectName(QStringLiteral("newName"));
  nameLabel_->setBuddy(name_);
  rate_->setObjectName(QStringLiteral("newRate"));
  rate_->setRange(0.1, 10000.0);
  rate_->setValue(kUsualRate);
  rateLabel_->setBuddy(rate_);
  calibration_->setObjectName(QStringLiteral("newCalibrationFile"));
  calibration_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  makeTable();
  makeRows();
  onRetranslate(this, [this] { retranslateUi(); });
  refresh();
}

void NewProjectPage::makeTable() {
  cameras_->setObjectName(QStringLiteral("newCameras"));
  cameras_->setColumnCount(2);
  cameras_->verticalHeader()->hide();
  cameras_->horizontalHeader()->setStretchLastSection(true);
  cameras_->setSelectionBehavior(QAbstractItemView::SelectRows);
  cameras_->setTabKeyNavigation(false);
  connect(cameras_, &QTableWidget::itemSelectionChanged, this, &NewProjectPage::refresh);
  connect(cameras_, &QTableWidget::itemChanged, this,
          [this](const QTableWidgetItem* item) { lookAtTyped(*item); });
}

QPushButton* NewProjectPage::addButton(const char* name, const std::function<void()>& act) {
  auto* button = new QPushButton(this);
  button->setObjectName(QLatin1String(name));
  connect(button, &QPushButton::clicked, this, act);
  return button;
}

void NewProjectPage::makeRows() {
  addVideos_ = addButton("newAddVideos", [this] { chooseVideos(); });
  addFolder_ = addButton("newAddFolder", [this] { chooseFolder(); });
  addDevices_ = addButton("newAddDevices", [this] { addConnectedCameras(); });
  addAddress_ = addButton("newAddAddress", [this] { addAddress(); });
  remove_ = addButton("newRemove", [this] { removeRow(); });
  chooseCalibration_ = addButton("newChooseCalibration", [this] { chooseCalibration(); });
  dropCalibration_ = addButton("newDropCalibration", [this] { setCalibration({}); });
  create_ = addButton("newCreate", [this] { createProject(); });
  create_->setDefault(true);
  cancel_ = addButton("newCancel", [this] {
    forgetWork();
    Q_EMIT cancelled();
  });
  buttons_->layout()->setSpacing(kSpacing);
  buttons_->addButton(create_, QDialogButtonBox::AcceptRole);
  buttons_->addButton(cancel_, QDialogButtonBox::RejectRole);
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
  column->setSpacing(kSpacing);
  column->addWidget(title_);
  column->addWidget(lead_);
  column->addSpacing(kSpacing);
  column->addLayout(row({addVideos_, addFolder_, addDevices_, addAddress_, remove_}, -1));
  column->addWidget(cameras_, 1);
  column->addLayout(row({rateLabel_, rate_}, -1));
  column->addSpacing(kSpacing);
  column->addLayout(
      row({calibrationLabel_, calibration_, dropCalibration_, chooseCalibration_}, 1));
  column->addLayout(row({nameLabel_, name_}, 1));
  column->addSpacing(kSpacing);
  column->addWidget(buttons_);
  auto* all = new QHBoxLayout(this);
  all->setContentsMargins(32, 32, 32, 24);
  all->addStretch(1);
  all->addWidget(middle, 10);
  all->addStretch(1);
}

void NewProjectPage::retranslateUi() {
  const auto button = [](QPushButton* which, const QString& text, const QString& hint) {
    which->setText(text);
    which->setToolTip(hint);
  };
  title_->setText(tr("New project"));
  lead_->setText(tr("One row per camera. Frame k of all recordings has to show the same instant."));
  button(addVideos_, tr("Add videos…"), tr("Video files, one per camera"));
  button(addFolder_, tr("Add image folder…"), tr("A folder of images, one per frame"));
  button(addDevices_, tr("Add connected cameras"), tr("All cameras connected to this computer"));
  button(addAddress_, tr("Add address"), tr("A device number or a network stream; type it in"));
  button(remove_, tr("Remove"), tr("Take the chosen cameras out"));
  button(
      chooseCalibration_, tr("Choose calibration…"),
      tr("TOML file with the cameras' calibration; names, or else the order, tell which is whose"));
  button(dropCalibration_, tr("None"), tr("Go without a calibration file"));
  button(create_, tr("Create"), tr("Make the project and show its first images"));
  button(cancel_, tr("Cancel"), tr("Back without making a project"));
  calibrationLabel_->setText(tr("Calibration:"));
  nameLabel_->setText(tr("Name:"));
  name_->setPlaceholderText(tr("as the folder is called"));
  name_->setToolTip(tr("Name of the project"));
  rateLabel_->setText(tr("Images per second:"));
  rate_->setToolTip(tr("Rate of image folders, 0.1 to 10,000 per second"));
  cameras_->setHorizontalHeaderLabels({tr("Camera"), tr("Images from")});
  cameras_->setAccessibleName(tr("Cameras of the new project"));
  setCalibration(calibrationFile_);
}

void NewProjectPage::begin(const QStringList& files) {
  // Whichever of them the platform puts first.
  setTabOrder(dropCalibration_, create_);
  setTabOrder(create_, cancel_);
  forgetWork();
  imageFolders_.clear();
  cameras_->setRowCount(0);
  name_->clear();
  setCalibration({});
  refresh();
  addFiles(files);
  addVideos_->setFocus();
}

std::vector<NewProjectPage::Place>
NewProjectPage::placesOf(const std::vector<std::string>& locations) {
  std::vector<Place> places;
  for (const std::string& location : locations) {
    const QString file = QString::fromStdString(location);
    places.push_back({location, showsImages(location),
                      QFileInfo::exists(file) && !file.startsWith(QStringLiteral("/dev/")),
                      guessedSource(location) == SourceKind::Images});
  }
  return places;
}

void NewProjectPage::search(std::function<std::vector<Place>()> look,
                            std::function<void(const std::vector<Place>&)> found) {
  ++underWay_;
  refresh();
  searches_->add([this, look = std::move(look), found = std::move(found)] {
    return [this, found, places = look()] {
      --underWay_;
      found(places);
      refresh();
    };
  });
}

void NewProjectPage::forgetWork() {
  making_.cancel();
  searches_ = std::make_unique<JobQueue>();
  underWay_ = 0;
}

void NewProjectPage::addFiles(const QStringList& files) {
  std::vector<std::string> names;
  std::ranges::transform(files, std::back_inserter(names), &QString::toStdString);
  std::vector<std::string> footage;
  for (const std::string& name : inNaturalOrder(std::move(names))) {
    const QString file = QString::fromStdString(name);
    if (file.endsWith(QStringLiteral(".toml"), Qt::CaseInsensitive)) {
      setCalibration(file);
    } else {
      footage.push_back(name);
    }
  }
  if (!footage.empty()) {
    search([footage] { return placesOf(footage); },
           [this](const std::vector<Place>& places) { addFootage(places); });
  }
}

void NewProjectPage::addFootage(const std::vector<Place>& places) {
  QStringList refused;
  for (const Place& place : places) {
    const QString file = QString::fromStdString(place.location);
    if (!place.showsImages) {
      refused << QFileInfo(file).fileName();
    } else if (!isListed(file)) { // dropped twice it is still one camera
      add(place);
    }
  }
  if (!refused.isEmpty()) {
    Q_EMIT failed(tr("Neither a video, nor images, nor a calibration: %1.")
                      .arg(refused.join(QStringLiteral(", "))));
  }
}

bool NewProjectPage::isListed(const QString& location) const {
  const auto found = cameras_->findItems(location, Qt::MatchFixedString | Qt::MatchCaseSensitive);
  return std::ranges::any_of(found, [](auto* item) { return item->column() == kSource; });
}

void NewProjectPage::add(const Place& place) {
  const int row = cameras_->rowCount();
  const QString location = QString::fromStdString(place.location);
  if (place.isImages) {
    imageFolders_.insert(location);
  }
  const QSignalBlocker known(cameras_); // nothing was typed
  cameras_->insertRow(row);
  const QString name = place.isFile ? QFileInfo(location).completeBaseName()
                                    : cameraName(std::string(), static_cast<std::size_t>(row));
  cameras_->setItem(row, kName, new QTableWidgetItem(name));
  cameras_->setItem(row, kSource, new QTableWidgetItem(location));
  cameras_->resizeColumnToContents(kName);
  refresh();
}

void NewProjectPage::lookAtTyped(const QTableWidgetItem& item) {
  if (item.column() != kSource) {
    return;
  }
  refresh();
  searches_->add([this, location = item.text()]() -> std::function<void()> {
    if (guessedSource(location.toStdString()) != SourceKind::Images) {
      return {};
    }
    return [this, location] {
      imageFolders_.insert(location);
      refresh();
    };
  });
}

void NewProjectPage::removeRow() {
  while (!cameras_->selectedItems().isEmpty()) {
    cameras_->removeRow(cameras_->selectedItems().front()->row());
  }
  refresh();
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
    search([folder] { return placesOf({folder.toStdString()}); },
           [this](const std::vector<Place>& places) { add(places.front()); });
  }
}

void NewProjectPage::addAddress() {
  add(Place());
  const int row = cameras_->rowCount() - 1;
  cameras_->setCurrentCell(row, kSource);
  cameras_->editItem(cameras_->item(row, kSource));
}

void NewProjectPage::addConnectedCameras() {
  search([] { return placesOf(connectedCameras()); },
         [this](const std::vector<Place>& devices) {
           std::ranges::for_each(devices, [this](const Place& device) { add(device); });
           if (devices.empty()) {
             Q_EMIT failed(tr("No camera is connected to this computer. A network camera can be "
                              "added by its address."));
           }
         });
}

void NewProjectPage::chooseCalibration() {
  const QString file =
      askForFile(this, tr("Choose a calibration"), tr("Calibrations (*.toml);;All files (*)"));
  if (!file.isEmpty()) {
    setCalibration(file);
  }
}

void NewProjectPage::setCalibration(const QString& file) {
  calibrationFile_ = file;
  calibration_->setText(file.isEmpty() ? tr("none: camera positions will be a guess")
                                       : QFileInfo(file).fileName());
  calibration_->setToolTip(file);
  dropCalibration_->setVisible(!file.isEmpty());
}

void NewProjectPage::refresh() {
  bool images = false;
  for (int row = 0; row < cameras_->rowCount(); ++row) {
    const QTableWidgetItem* source = cameras_->item(row, kSource);
    images = images || (source != nullptr && imageFolders_.contains(source->text()));
  }
  rateLabel_->setVisible(images);
  rate_->setVisible(images);
  remove_->setEnabled(!cameras_->selectedItems().isEmpty());
  create_->setEnabled(cameras_->rowCount() > 0 && underWay_ == 0);
}

NewProject NewProjectPage::wanted() const {
  NewProject wanted;
  wanted.name = name_->text().toStdString();
  const auto text = [this](int row, Column column) {
    const QTableWidgetItem* item = cameras_->item(row, column);
    return item == nullptr ? std::string() : item->text().trimmed().toStdString();
  };
  for (int row = 0; row < cameras_->rowCount(); ++row) {
    wanted.cameras.push_back({.name = text(row, kName), .location = text(row, kSource)});
  }
  if (!calibrationFile_.isEmpty()) {
    wanted.calibration = calibrationFile_.toStdString();
  }
  wanted.framesPerSecond = rate_->value();
  return wanted;
}

void NewProjectPage::createProject() {
  create_->setEnabled(false);
  making_.start([this, wanted = wanted()](const BackgroundJob::Progress&) mutable {
    bool images = false;
    for (NewCamera& camera : wanted.cameras) {
      camera.source = guessedSource(camera.location);
      images = images || camera.source == SourceKind::Images;
    }
    wanted.framesPerSecond = images ? wanted.framesPerSecond : 0.0;
    auto result = std::make_shared<Result<MadeProject>>(makeProject(wanted));
    return [this, result] { finish(*result); };
  });
}

void NewProjectPage::finish(const Result<MadeProject>& result) {
  refresh();
  if (!result) {
    Q_EMIT failed(errorSentence(result.error()));
    return;
  }
  QString note;
  if (result->lacksCalibration) {
    note = tr("Without a calibration the camera positions are a guess: images can be tracked, but "
              "positions in space mean nothing yet.");
  } else if (result->matchedByOrder) {
    note = tr("The calibration names its cameras differently: they were taken in its order.");
  }
  Q_EMIT made(result->project, note);
}

} // namespace dewpoint::ui

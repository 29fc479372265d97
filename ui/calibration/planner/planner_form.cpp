// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/planner/planner_form.h"

#include "core/base/angle.h"
#include "core/base/units.h"
#include "core/calibration/manual/interactive_pose.h"
#include "ui/calibration/planner/rig_planner.h"
#include "ui/text/axis_names.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/number_field.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>

#include <cmath>

namespace dewpoint::ui {

PlannerForm::PlannerForm(RigPlanner& plan, QWidget* parent) : QWidget(parent), plan_(plan) {
  setObjectName(QStringLiteral("planFields"));
  createWidgets();
  connectFields();
  connectSearch();
  onRetranslate(this, [this] { retranslateUi(); });
}

void PlannerForm::createWidgets() {
  const auto button = [this](const char* name) {
    auto* made = new QPushButton(this);
    made->setObjectName(QLatin1String(name));
    return made;
  };
  const auto field = [this](const QString& name, const NumberRange& range) {
    return makeNumberField(name, range, this);
  };
  add_ = button("planAdd");
  remove_ = button("planRemove");
  cameraLabel_ = new QLabel(this);
  camera_ = new QComboBox(this);
  camera_->setObjectName(QStringLiteral("planCamera"));
  makeNarrow(*camera_);
  positionLabel_ = new QLabel(this);
  targetLabel_ = new QLabel(this);
  lensLabel_ = new QLabel(this);
  fieldOfView_ = field(QStringLiteral("planFieldOfView"), {1.0, 170.0, 1.0, 1});
  imageWidth_ = field(QStringLiteral("planImageWidth"), {16.0, 20000.0, 16.0, 0});
  imageHeight_ = field(QStringLiteral("planImageHeight"), {16.0, 20000.0, 16.0, 0});
  find_ = button("planFind");
  wallLabel_ = new QLabel(this);
  wall_ = field(QStringLiteral("planWallDistance"), {0.0, 100.0, 0.1, 3});
  progress_ = new QProgressBar(this);
  progress_->setObjectName(QStringLiteral("planProgress"));
  progress_->setRange(0, 100);
  progress_->hide();
  cancel_ = button("planCancel");
  cancel_->hide();
  message_ = new QLabel(this);
  message_->setObjectName(QStringLiteral("planSaid"));
  message_->setWordWrap(true);
  message_->hide();
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  for (int column = 0; column < 3; ++column) {
    grid->setColumnStretch(column, 1);
  }
  grid->addWidget(add_, 0, 0, 1, 2);
  grid->addWidget(remove_, 0, 2);
  grid->addWidget(cameraLabel_, 1, 0);
  grid->addWidget(camera_, 1, 1, 1, 2);
  grid->addWidget(positionLabel_, 2, 0, 1, 3);
  grid->addWidget(targetLabel_, 4, 0, 1, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const QString axis = QLatin1String(kAxisLetters[k]);
    position_[k] = field(QStringLiteral("planPlace") + axis, {-1e3, 1e3, 0.05, 3});
    target_[k] = field(QStringLiteral("planTarget") + axis, {-1e3, 1e3, 0.05, 3});
    grid->addWidget(position_[k], 3, static_cast<int>(k));
    grid->addWidget(target_[k], 5, static_cast<int>(k));
  }
  grid->addWidget(lensLabel_, 6, 0, 1, 3);
  grid->addWidget(fieldOfView_, 7, 0);
  grid->addWidget(imageWidth_, 7, 1);
  grid->addWidget(imageHeight_, 7, 2);
  grid->addWidget(wallLabel_, 8, 0, 1, 2);
  grid->addWidget(wall_, 8, 2);
  grid->addWidget(find_, 9, 0, 1, 3);
  grid->addWidget(progress_, 10, 0, 1, 2);
  grid->addWidget(cancel_, 10, 2);
  grid->addWidget(message_, 11, 0, 1, 3);
  cameraLabel_->setBuddy(camera_);
  positionLabel_->setBuddy(position_[0]);
  targetLabel_->setBuddy(target_[0]);
  lensLabel_->setBuddy(fieldOfView_);
  wallLabel_->setBuddy(wall_);
}

void PlannerForm::connectFields() {
  connect(&plan_, &RigPlanner::changed, this, &PlannerForm::refresh);
  connect(add_, &QPushButton::clicked, &plan_, &RigPlanner::addCamera);
  connect(remove_, &QPushButton::clicked, this,
          [this] { plan_.removeCamera(plan_.selectedCamera()); });
  connect(camera_, &QComboBox::activated, &plan_, &RigPlanner::selectCamera);
  for (int k = 0; k < 3; ++k) {
    connect(position_[std::size_t(k)], &QDoubleSpinBox::valueChanged, this,
            [this, k](double value) { editPosition(k, value); });
    connect(target_[std::size_t(k)], &QDoubleSpinBox::valueChanged, this,
            [this, k](double value) { editTarget(k, value); });
  }
  for (QDoubleSpinBox* lens : {fieldOfView_, imageWidth_, imageHeight_}) {
    connect(lens, &QDoubleSpinBox::valueChanged, this, &PlannerForm::editLens);
  }
  connect(wall_, &QDoubleSpinBox::valueChanged, &plan_, &RigPlanner::setWallDistance);
}

void PlannerForm::connectSearch() {
  BackgroundJob& search = plan_.positionSearchJob();
  connect(find_, &QPushButton::clicked, &plan_, &RigPlanner::findBestCameraPosition);
  connect(cancel_, &QPushButton::clicked, &search, &BackgroundJob::cancel);
  const auto show = [this](bool running) {
    progress_->setValue(0);
    progress_->setVisible(running);
    cancel_->setVisible(running);
    find_->setEnabled(!running);
  };
  connect(&search, &BackgroundJob::started, this, [show] { show(true); });
  connect(&search, &BackgroundJob::ended, this, [show] { show(false); });
  connect(&search, &BackgroundJob::progressChanged, this,
          [this](double part) { progress_->setValue(static_cast<int>(100.0 * part)); });
  connect(&plan_, &RigPlanner::messageRequested, this, [this](const QString& sentence) {
    message_->setText(sentence);
    message_->setVisible(!sentence.isEmpty());
  });
}

void PlannerForm::retranslateUi() {
  const auto name = [](QWidget* field, const QString& text, const QString& tip) {
    field->setAccessibleName(text);
    field->setToolTip(tip);
  };
  add_->setText(tr("Add planned camera"));
  name(add_, tr("Add planned camera"),
       tr("Add a planned camera; you can then drag it in the bird's-eye view, or enter its "
          "position (%1)")
           .arg(QStringLiteral("Shift+P")));
  remove_->setText(tr("Remove"));
  name(remove_, tr("Remove the planned camera"), tr("Remove the selected planned camera"));
  cameraLabel_->setText(tr("Planned camera"));
  name(camera_, tr("Planned camera"), tr("Choose the planned camera whose values are shown below"));
  positionLabel_->setText(tr("Position x, y, z"));
  targetLabel_->setText(tr("Looks at x, y, z"));
  lensLabel_->setText(tr("Field of view, image width and height"));
  for (std::size_t k = 0; k < 3; ++k) {
    const QString axis = QLatin1String(kAxisLetters[k]);
    name(position_[k], tr("Planned position (%1 coordinate)").arg(axis),
         tr("Position of the camera, in meters"));
    name(target_[k], tr("Planned camera looks at (%1 coordinate)").arg(axis),
         tr("A point that the planned camera looks at, in meters"));
    position_[k]->setSuffix(QStringLiteral(" m"));
    target_[k]->setSuffix(QStringLiteral(" m"));
  }
  name(fieldOfView_, tr("Field of view"), tr("Horizontal field of view of the camera"));
  fieldOfView_->setSuffix(QStringLiteral("°"));
  name(imageWidth_, tr("Image width"), tr("Width of the planned camera's image, in pixels"));
  name(imageHeight_, tr("Image height"), tr("Height of the planned camera's image, in pixels"));
  imageWidth_->setSuffix(QStringLiteral(" px"));
  imageHeight_->setSuffix(QStringLiteral(" px"));
  wallLabel_->setText(tr("Distance to walls and ceiling"));
  name(wall_, tr("Distance from the volume to the walls and the ceiling"),
       tr("The search places the camera on four walls and a ceiling at this distance from the "
          "volume"));
  wall_->setSuffix(QStringLiteral(" m"));
  cancel_->setText(tr("Cancel"));
  name(cancel_, tr("Cancel the search"), tr("Stop the search without adding a camera"));
  refresh();
}

void PlannerForm::refreshNames() {
  const QSignalBlocker quiet(camera_);
  camera_->clear();
  for (const Camera& camera : plan_.plannedCameras()) {
    camera_->addItem(QString::fromStdString(camera.name));
  }
  camera_->setCurrentIndex(plan_.selectedCamera());
  camera_->setPlaceholderText(plan_.plannedCameras().empty() ? tr("none yet")
                                                             : tr("none selected"));
}

void PlannerForm::refresh() {
  refreshNames();
  const bool any = plan_.selectedCamera() >= 0;
  remove_->setEnabled(any);
  camera_->setEnabled(!plan_.plannedCameras().empty());
  const Camera camera =
      any ? plan_.plannedCameras()[std::size_t(plan_.selectedCamera())] : Camera();
  const Eigen::Vector3d target = aimPoint(camera, plan_.volume().min().z());
  for (int k = 0; k < 3; ++k) {
    const auto index = std::size_t(k);
    position_[index]->setEnabled(any);
    target_[index]->setEnabled(any);
    showValue(*position_[index], any ? camera.center()[k] : 0.0);
    showValue(*target_[index], any ? target[k] : 0.0);
  }
  showValue(*fieldOfView_,
            inDegrees(any ? fieldOfView(camera) : plan_.lens().horizontalFieldOfView));
  showValue(*imageWidth_, any ? camera.intrinsics.width : plan_.lens().imageWidth);
  showValue(*imageHeight_, any ? camera.intrinsics.height : plan_.lens().imageHeight);
  showValue(*wall_, plan_.wallDistance());
  const QString next = plan_.nextCameraName();
  find_->setText(tr("Find best position for %1").arg(next));
  find_->setAccessibleName(find_->text());
  find_->setToolTip(tr("Search the walls and the ceiling for the position where another camera "
                       "would help most (%1)")
                        .arg(QStringLiteral("Shift+F")));
}

void PlannerForm::editPosition(int axis, double value) {
  if (plan_.selectedCamera() >= 0) {
    const Camera camera = plan_.plannedCameras()[std::size_t(plan_.selectedCamera())];
    Eigen::Vector3d place = camera.center();
    place[axis] = value;
    plan_.changeCamera(plan_.selectedCamera(), withPosition(camera, place));
  }
}

void PlannerForm::editTarget(int axis, double value) {
  if (plan_.selectedCamera() >= 0) {
    const Camera camera = plan_.plannedCameras()[std::size_t(plan_.selectedCamera())];
    Eigen::Vector3d target = aimPoint(camera, plan_.volume().min().z());
    target[axis] = value;
    plan_.changeCamera(plan_.selectedCamera(), lookingAt(camera, target));
  }
}

void PlannerForm::editLens() {
  plan_.setLens({static_cast<int>(imageWidth_->value()), static_cast<int>(imageHeight_->value()),
                 fieldOfView_->value() * base::kDegree});
}

} // namespace dewpoint::ui

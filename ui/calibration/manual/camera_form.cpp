// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/camera_form.h"

#include "core/base/angle.h"
#include "core/base/units.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/document/camera_list_model.h"
#include "ui/text/axis_names.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/tab_order.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>

namespace dewpoint::ui {
CameraForm::CameraForm(ManualCalibration& manual, QWidget* parent)
    : QWidget(parent), manual_(manual) {
  setObjectName(QStringLiteral("cameraFields"));
  createWidgets();
  connectFields();
  onRetranslate(this, [this] { retranslateUi(); });
}

void CameraForm::createWidgets() {
  cameraLabel_ = new QLabel(this);
  camera_ = makeChoiceField("handCamera", this);
  camera_->setModel(&manual_.cameras());
  positionLabel_ = new QLabel(this);
  unit_ = makeChoiceField("handUnit", this);
  aimLabel_ = new QLabel(this);
  aimMode_ = makeChoiceField("handAimMode", this);
  lensLabel_ = new QLabel(this);
  lensMode_ = makeChoiceField("handLensMode", this);
  lens_ = makeNumberField(QStringLiteral("handLens"), {}, this);
  dragLabel_ = new QLabel(this);
  dragMode_ = makeChoiceField("handDragMode", this);
  fitFocal_ = new QCheckBox(this);
  fitFocal_->setObjectName(QStringLiteral("handFocalMay"));
  keysLabel_ = new QLabel(this);
  keyMode_ = makeChoiceField("handKeyMode", this);
  keyFrame_ = makeChoiceField("handKeyFrame", this);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  for (int column = 0; column < 3; ++column) {
    grid->setColumnStretch(column, 1);
  }
  grid->addWidget(cameraLabel_, 0, 0);
  grid->addWidget(camera_, 0, 1, 1, 2);
  grid->addWidget(positionLabel_, 1, 0);
  grid->addWidget(unit_, 1, 1, 1, 2);
  for (std::size_t k = 0; k < 3; ++k) {
    position_[k] =
        makeNumberField(QStringLiteral("handPosition") + QLatin1String(kAxisLetters[k]), {}, this);
    grid->addWidget(position_[k], 2, static_cast<int>(k));
  }
  grid->addWidget(aimLabel_, 3, 0);
  grid->addWidget(aimMode_, 3, 1, 1, 2);
  const char* const names[] = {"handAimX", "handAimY", "handAimZ", "handRoll"};
  for (std::size_t k = 0; k < 4; ++k) {
    aim_[k] = makeNumberField(QLatin1String(names[k]), {}, this);
    grid->addWidget(aim_[k], k < 3 ? 4 : 5, k < 3 ? static_cast<int>(k) : 0);
  }
  grid->addWidget(lensLabel_, 6, 0);
  grid->addWidget(lensMode_, 6, 1);
  grid->addWidget(lens_, 6, 2);
  grid->addWidget(dragLabel_, 7, 0);
  grid->addWidget(dragMode_, 7, 1, 1, 2);
  grid->addWidget(fitFocal_, 8, 0, 1, 3);
  grid->addWidget(keysLabel_, 9, 0);
  grid->addWidget(keyMode_, 9, 1);
  grid->addWidget(keyFrame_, 9, 2);
  orderTabsByRows(*grid);
  cameraLabel_->setBuddy(camera_);
  positionLabel_->setBuddy(position_[0]);
  aimLabel_->setBuddy(aim_[0]);
  lensLabel_->setBuddy(lens_);
  dragLabel_->setBuddy(dragMode_);
  keysLabel_->setBuddy(keyMode_);
}

void CameraForm::connectFields() {
  connect(&manual_, &ManualCalibration::changed, this, &CameraForm::refresh);
  connect(&manual_, &ManualCalibration::cameraSelected, this, &CameraForm::refresh);
  connect(camera_, &QComboBox::activated, &manual_, &ManualCalibration::selectCamera);
  for (QComboBox* mode : {unit_, aimMode_, lensMode_}) {
    connect(mode, &QComboBox::currentIndexChanged, this, [this] {
      showUnits();
      refresh();
    });
  }
  for (int k = 0; k < 3; ++k) {
    connect(position_[static_cast<std::size_t>(k)], &QDoubleSpinBox::valueChanged, this,
            [this, k](double value) { editPosition(k, value); });
  }
  for (int k = 0; k < 4; ++k) {
    connect(aim_[static_cast<std::size_t>(k)], &QDoubleSpinBox::valueChanged, this,
            [this, k](double value) { editAim(k, value); });
  }
  connect(lens_, &QDoubleSpinBox::valueChanged, this, &CameraForm::editLens);
  for (QDoubleSpinBox* field : findChildren<QDoubleSpinBox*>()) {
    connect(field, &QDoubleSpinBox::editingFinished, &manual_, &ManualCalibration::endStepMerging);
  }
  const auto drag = [this] {
    manual_.setDragSettings({dragMode_->currentIndex() == 1 ? DragMode::Slide : DragMode::Turn,
                             fitFocal_->isChecked()});
  };
  connect(dragMode_, &QComboBox::currentIndexChanged, this, drag);
  connect(fitFocal_, &QCheckBox::toggled, this, drag);
  connect(keyMode_, &QComboBox::currentIndexChanged, this,
          [this](int index) { manual_.setKeyMode(index == 1 ? KeyMode::Turn : KeyMode::Move); });
  connect(keyFrame_, &QComboBox::currentIndexChanged, this, [this](int index) {
    manual_.setNudgeFrame(index == 1 ? NudgeFrame::World : NudgeFrame::Camera);
  });
}

void CameraForm::retranslateUi() {
  const auto name = [](QWidget* field, const QString& text, const QString& tip) {
    field->setAccessibleName(text);
    field->setToolTip(tip);
  };
  cameraLabel_->setText(tr("Camera"));
  name(camera_, tr("Camera"), tr("The camera to adjust; you can also click its image"));
  positionLabel_->setText(tr("Position"));
  setChoices(*unit_, {tr("meters"), tr("centimeters")});
  name(unit_, tr("Unit of positions"), tr("Unit for showing and entering positions"));
  aimLabel_->setText(tr("Direction"));
  setChoices(*aimMode_, {tr("point, roll"), tr("yaw, pitch, roll")});
  name(aimMode_, tr("Direction format"),
       tr("Enter the direction as a point that the camera looks at, or as angles: yaw is measured "
          "from x toward y, pitch above the horizon, and roll about the line of sight"));
  lensLabel_->setText(tr("Lens"));
  setChoices(*lensMode_, {tr("focal length"), tr("field of view")});
  name(lensMode_, tr("Lens parameter"),
       tr("Focal length in pixels, or the horizontal field of view in degrees"));
  name(lens_, tr("Focal length or field of view"),
       tr("Magnification of the camera; the keys + and − also change it"));
  dragLabel_->setText(tr("Dragging"));
  setChoices(*dragMode_, {tr("turns the camera"), tr("slides the camera")});
  name(dragMode_, tr("Effect of dragging"),
       tr("What the camera does while you drag the grid and no point is held. Click points of the "
          "grid to hold up to three of them."));
  fitFocal_->setText(tr("Also fit the focal length when three points are held"));
  fitFocal_->setToolTip(
      tr("Three held points fix the pose. With this option, dragging changes the focal length, and "
         "the pose is adapted so that the three points stay in place"));
  keysLabel_->setText(tr("Keys"));
  setChoices(*keyMode_, {tr("move"), tr("turn")});
  name(keyMode_, tr("What the keys do to the camera"),
       tr("The arrow keys, the page keys and W, A, S, D, Q and E move or turn the camera by 1 cm "
          "or 0.2° a step. With Shift, the steps are ten times as large. With Ctrl, the steps of "
          "the arrow and page keys are a tenth as large."));
  setChoices(*keyFrame_, {tr("camera axes"), tr("world axes")});
  name(keyFrame_, tr("Axes along which the keys move the camera"),
       tr("Move along the camera's right, forward and up directions, or along the world axes"));
  showUnits();
  refresh();
}

double CameraForm::metersPerUnit() const {
  return unit_->currentIndex() == 1 ? 0.01 : 1.0;
}

bool CameraForm::looksAtPoint() const {
  return aimMode_->currentIndex() != 1;
}

bool CameraForm::showsFieldOfView() const {
  return lensMode_->currentIndex() == 1;
}

void CameraForm::showUnits() {
  const bool centimeters = unit_->currentIndex() == 1;
  const NumberRange length =
      centimeters ? NumberRange{-1e6, 1e6, 1.0, 1} : NumberRange{-1e4, 1e4, 0.01, 3};
  const QString unit = centimeters ? QStringLiteral(" cm") : QStringLiteral(" m");
  const QString degrees = QStringLiteral("°");
  const QString heading[] = {tr("Yaw"), tr("Pitch"), QString()};
  const QString prefix[] = {tr("yaw"), tr("pitch"), QString()};
  for (std::size_t k = 0; k < 3; ++k) {
    const QString axis = QLatin1String(kAxisLetters[k]);
    setRange(*position_[k], length, unit);
    position_[k]->setPrefix(axis.toLower() + QLatin1Char(' '));
    position_[k]->setAccessibleName(tr("Position %1").arg(axis));
    position_[k]->setToolTip(tr("%1 coordinate of the camera's position").arg(axis));
    if (looksAtPoint()) {
      setRange(*aim_[k], length, unit);
      aim_[k]->setPrefix(axis.toLower() + QLatin1Char(' '));
      aim_[k]->setAccessibleName(tr("Looks at (%1 coordinate)").arg(axis));
      aim_[k]->setToolTip(tr("%1 coordinate of the point that the camera looks at").arg(axis));
    } else {
      setRange(*aim_[k], {-180.0, 180.0, 0.1, 2}, degrees);
      aim_[k]->setPrefix(prefix[k] + QLatin1Char(' '));
      aim_[k]->setAccessibleName(heading[k]);
      aim_[k]->setToolTip(k == 0 ? tr("Direction seen from above: 0° along x, 90° along y")
                                 : tr("Angle above the horizon; straight down is −90°"));
    }
  }
  aim_[2]->setVisible(looksAtPoint());
  auto* grid = static_cast<QGridLayout*>(layout());
  grid->removeWidget(aim_[3]);
  grid->addWidget(aim_[3], looksAtPoint() ? 5 : 4, looksAtPoint() ? 0 : 2); // three in a row
  setRange(*aim_[3], {-180.0, 180.0, 0.1, 2}, degrees);
  aim_[3]->setPrefix(tr("roll") + QLatin1Char(' '));
  aim_[3]->setAccessibleName(tr("Roll"));
  aim_[3]->setToolTip(tr("Clockwise rotation about the line of sight"));
  showsFieldOfView() ? setRange(*lens_, {1.0, 179.0, 0.1, 2}, degrees)
                     : setRange(*lens_, {1.0, 1e5, 1.0, 1}, QStringLiteral(" px"));
}

void CameraForm::refresh() {
  camera_->setCurrentIndex(manual_.camera());
  setEnabled(manual_.cameraCount() > 0);
  if (manual_.cameraCount() == 0) {
    return;
  }
  const Camera camera = manual_.cameraInProject(manual_.camera());
  const Heading heading = headingOf(camera);
  const Eigen::Vector3d target = aimPoint(camera, manual_.grid().origin.z());
  const double angles[] = {inDegrees(heading.yaw), inDegrees(heading.pitch), 0.0};
  for (int k = 0; k < 3; ++k) {
    const auto index = static_cast<std::size_t>(k);
    showValue(*position_[index], camera.center()[k] / metersPerUnit());
    showValue(*aim_[index], looksAtPoint() ? target[k] / metersPerUnit() : angles[k]);
  }
  showValue(*aim_[3], inDegrees(heading.roll));
  showValue(*lens_, showsFieldOfView() ? inDegrees(fieldOfView(camera)) : camera.intrinsics.focalX);
}

void CameraForm::change(const QString& what, const QString& value, const Camera& camera,
                        const char* key) {
  manual_.changeCamera(
      manual_.camera(),
      tr("%1: %2 %3").arg(manual_.nameOf(manual_.camera()), what, value).simplified(), camera, key);
  refresh(); // also when it was refused
}

void CameraForm::editPosition(int axis, double value) {
  const Camera camera = manual_.cameraInProject(manual_.camera());
  Eigen::Vector3d position = camera.center();
  position[axis] = value * metersPerUnit();
  const auto* field = position_[static_cast<std::size_t>(axis)];
  change(tr("position"), field->text(), withPosition(camera, position), kAxisLetters[axis]);
}

void CameraForm::editAim(int index, double value) {
  const Camera camera = manual_.cameraInProject(manual_.camera());
  const auto* field = aim_[static_cast<std::size_t>(index)];
  const char* const keys[] = {"aim x", "aim y", "aim z", "roll"};
  if (index < 3 && looksAtPoint()) {
    Eigen::Vector3d target = aimPoint(camera, manual_.grid().origin.z());
    target[index] = value * metersPerUnit();
    change(tr("looks at"), field->text(), lookingAt(camera, target), keys[index]);
    return;
  }
  Heading heading = headingOf(camera);
  (index == 0 ? heading.yaw : index == 1 ? heading.pitch : heading.roll) = value * base::kDegree;
  change({}, field->text(), withHeading(camera, heading), keys[index]); // the field names itself
}

void CameraForm::editLens(double value) {
  const Camera camera = manual_.cameraInProject(manual_.camera());
  const double focal = showsFieldOfView() ? focalLengthOf(camera, value * base::kDegree) : value;
  change(showsFieldOfView() ? tr("field of view") : tr("focal length"), lens_->text(),
         withFocalLength(camera, focal), "lens");
}

} // namespace dewpoint::ui

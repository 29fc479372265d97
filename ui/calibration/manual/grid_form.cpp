// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/grid_form.h"

#include "core/base/angle.h"
#include "core/base/units.h"
#include "ui/calibration/manual_calibration.h"
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
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

namespace dewpoint::ui {
GridForm::GridForm(ManualCalibration& manual, QWidget* parent) : QWidget(parent), manual_(manual) {
  setObjectName(QStringLiteral("gridFields"));
  createWidgets();
  connectFields();
  onRetranslate(this, [this] { retranslateUi(); });
}

void GridForm::createWidgets() {
  kindLabel_ = new QLabel(this);
  kind_ = new QComboBox(this);
  kind_->setObjectName(QStringLiteral("gridKind"));
  makeNarrow(*kind_);
  sizeLabel_ = new QLabel(this);
  originLabel_ = new QLabel(this);
  stepLabel_ = new QLabel(this);
  step_ = makeNumberField(QStringLiteral("gridStep"), {0.001, 100.0, 0.05, 3}, this);
  rotation_ = makeNumberField(QStringLiteral("gridTurn"), {-360.0, 360.0, 1.0, 2}, this);
  opacityLabel_ = new QLabel(this);
  opacity_ = new QSlider(Qt::Horizontal, this);
  opacity_->setObjectName(QStringLiteral("gridOpacity"));
  opacity_->setRange(0, 100);
  opacity_->setValue(80);
  edges_ = new QCheckBox(this);
  edges_->setObjectName(QStringLiteral("gridEdges"));
  compareLabel_ = new QLabel(this);
  compare_ = makeChoiceField("gridCompare", this);
  flip_ = new QPushButton(this);
  flip_->setObjectName(QStringLiteral("gridFlip"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  for (int column = 0; column < 3; ++column) {
    grid->setColumnStretch(column, 1);
  }
  grid->addWidget(kindLabel_, 0, 0);
  grid->addWidget(kind_, 0, 1, 1, 2);
  grid->addWidget(sizeLabel_, 1, 0, 1, 3);
  grid->addWidget(originLabel_, 3, 0, 1, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const QString axis = QLatin1String(kAxisLetters[k]);
    size_[k] = makeNumberField(QStringLiteral("gridSize") + axis, {0.001, 1e3, 0.1, 3}, this);
    origin_[k] = makeNumberField(QStringLiteral("gridOrigin") + axis, {-1e3, 1e3, 0.1, 3}, this);
    grid->addWidget(size_[k], 2, static_cast<int>(k));
    grid->addWidget(origin_[k], 4, static_cast<int>(k));
  }
  grid->addWidget(stepLabel_, 5, 0);
  grid->addWidget(step_, 5, 1);
  grid->addWidget(rotation_, 5, 2);
  grid->addWidget(opacityLabel_, 6, 0);
  grid->addWidget(opacity_, 6, 1, 1, 2);
  grid->addWidget(edges_, 7, 0, 1, 2);
  grid->addWidget(flip_, 7, 2);
  grid->addWidget(compareLabel_, 8, 0);
  grid->addWidget(compare_, 8, 1, 1, 2);
  orderTabsByRows(*grid);
  kindLabel_->setBuddy(kind_);
  sizeLabel_->setBuddy(size_[0]);
  originLabel_->setBuddy(origin_[0]);
  stepLabel_->setBuddy(step_);
  opacityLabel_->setBuddy(opacity_);
  compareLabel_->setBuddy(compare_);
}

void GridForm::connectFields() {
  connect(&manual_, &ManualCalibration::changed, this, &GridForm::refresh);
  connect(kind_, &QComboBox::activated, this, [this](int index) {
    edit([index](ReferenceGrid& grid) { grid.kind = static_cast<GridKind>(index); }, "grid kind");
  });
  const char* const sizeKeys[] = {"grid size x", "grid size y", "grid size z"};
  const char* const originKeys[] = {"grid origin x", "grid origin y", "grid origin z"};
  for (int k = 0; k < 3; ++k) {
    const auto index = static_cast<std::size_t>(k);
    connect(size_[index], &QDoubleSpinBox::valueChanged, this,
            [this, k, key = sizeKeys[k]](double value) {
              edit([=](ReferenceGrid& grid) { grid.size[k] = value; }, key);
            });
    connect(origin_[index], &QDoubleSpinBox::valueChanged, this,
            [this, k, key = originKeys[k]](double value) {
              edit([=](ReferenceGrid& grid) { grid.origin[k] = value; }, key);
            });
  }
  connect(step_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit([value](ReferenceGrid& grid) { grid.step = value; }, "grid step");
  });
  connect(rotation_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit([value](ReferenceGrid& grid) { grid.rotationAngle = value * base::kDegree; }, "grid turn");
  });
  for (QDoubleSpinBox* field : findChildren<QDoubleSpinBox*>()) {
    connect(field, &QDoubleSpinBox::editingFinished, &manual_, &ManualCalibration::endStepMerging);
  }
  connect(opacity_, &QSlider::valueChanged, this,
          [this](int percent) { manual_.setGridOpacity(percent / 100.0); });
  connect(edges_, &QCheckBox::toggled, &manual_, &ManualCalibration::setEdgesShown);
  connect(compare_, &QComboBox::currentIndexChanged, this, [this](int index) {
    manual_.setComparedCameras(index == 1 ? EarlierCameras::LastChange
                                          : EarlierCameras::PanelOpened);
  });
  connect(flip_, &QPushButton::pressed, this,
          [this] { manual_.showEarlierCameras(manual_.comparedCameras()); });
  connect(flip_, &QPushButton::released, this, [this] { manual_.showEarlierCameras({}); });
}

void GridForm::edit(const std::function<void(ReferenceGrid&)>& change, const char* key) {
  ReferenceGrid grid = manual_.grid();
  change(grid);
  manual_.setGrid(tr("Change the reference grid"), grid, key);
  refresh(); // also when it was refused
}

void GridForm::retranslateUi() {
  const auto name = [](QWidget* field, const QString& text, const QString& tip) {
    field->setAccessibleName(text);
    field->setToolTip(tip);
  };
  kindLabel_->setText(tr("Grid on"));
  {
    const QSignalBlocker quiet(kind_);
    kind_->clear();
    kind_->addItems({tr("the floor"), tr("a wall"), tr("a box")});
  }
  name(kind_, tr("Kind of grid"), tr("Surface of the room on which the grid lies"));
  sizeLabel_->setText(tr("Size along x, y, z"));
  originLabel_->setText(tr("Origin x, y, z"));
  for (std::size_t k = 0; k < 3; ++k) {
    const QString axis = QLatin1String(kAxisLetters[k]);
    name(size_[k], tr("Size along %1").arg(axis), tr("Size of the grid, in meters"));
    name(origin_[k], tr("Origin %1").arg(axis),
         tr("Position of the corner at which the axes of the grid start, in meters"));
    size_[k]->setSuffix(QStringLiteral(" m"));
    origin_[k]->setSuffix(QStringLiteral(" m"));
  }
  stepLabel_->setText(tr("Spacing, rotation"));
  name(step_, tr("Spacing of the grid"), tr("Distance between lines, in meters"));
  step_->setSuffix(QStringLiteral(" m"));
  name(rotation_, tr("Rotation of the grid"),
       tr("Rotation about the vertical, counterclockwise as seen from above"));
  rotation_->setSuffix(QStringLiteral("°"));
  opacityLabel_->setText(tr("Opacity"));
  name(opacity_, tr("Opacity of the grid"), tr("How strongly the grid is drawn over the images"));
  edges_->setText(tr("Show image edges"));
  edges_->setToolTip(tr("Dim the images except for their edges"));
  flip_->setText(tr("Before"));
  name(flip_, tr("Show the grid with the camera poses before the changes"),
       tr("Hold down this button to draw the grid with earlier camera poses. Choose below which "
          "earlier poses are used. The key B does the same after you have clicked an image"));
  compareLabel_->setText(tr("Before shows"));
  setChoices(*compare_,
             {tr("poses when the panel was opened"), tr("poses before the last change")});
  name(compare_, tr("Earlier camera poses that the button Before shows"),
       tr("The cameras as they were when you opened this panel, or as they were before the last "
          "step that changed a camera"));
  refresh();
}

void GridForm::refresh() {
  const ReferenceGrid grid = manual_.grid();
  kind_->setCurrentIndex(static_cast<int>(grid.kind));
  for (int k = 0; k < 3; ++k) {
    const auto index = static_cast<std::size_t>(k);
    showValue(*size_[index], grid.size[k]);
    showValue(*origin_[index], grid.origin[k]);
  }
  size_[1]->setEnabled(grid.kind != GridKind::Wall);
  size_[2]->setEnabled(grid.kind != GridKind::Floor);
  showValue(*step_, grid.step);
  showValue(*rotation_, inDegrees(grid.rotationAngle));
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/volume_form.h"

#include "core/project/project.h"
#include "core/setup/seen_by_cameras.h"
#include "ui/document/document.h"
#include "ui/text/axis_names.h"
#include "ui/widgets/named_widgets.h"
#include "ui/widgets/number_field.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace dewpoint::ui {

namespace {

/// Meters. As far as a project may say it, in steps of the width of a hand.
constexpr NumberRange kCoordinates{-1e4, 1e4, 0.1, 3};
/// Where neither the project nor its cameras say anything.
WorldBox unitBox() {
  return {Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0)};
}

} // namespace

VolumeForm::VolumeForm(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), state_(new QLabel(this)),
      fromCameras_(makeButton("volumeFromCameras", this)), none_(makeButton("volumeNone", this)) {
  setObjectName(QStringLiteral("volumeForm"));
  createWidgets();
  connectFields();
  refresh();
}

void VolumeForm::createWidgets() {
  state_->setObjectName(QStringLiteral("volumeState"));
  state_->setWordWrap(true);
  state_->setForegroundRole(QPalette::PlaceholderText);
  const std::array labels{new QLabel(tr("Minimum X, Y, Z"), this),
                          new QLabel(tr("Maximum X, Y, Z"), this)};
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  grid->addWidget(state_, 0, 0, 1, 3);
  for (std::size_t corner = 0; corner < fields_.size(); ++corner) {
    const int row = 1 + 2 * static_cast<int>(corner);
    grid->addWidget(labels[corner], row, 0, 1, 3);
    for (std::size_t axis = 0; axis < kAxisLetters.size(); ++axis) {
      const QString name = QLatin1String(kAxisLetters[axis]);
      QDoubleSpinBox* field = makeNumberField(
          (corner == 0 ? QStringLiteral("volumeFrom") : QStringLiteral("volumeTo")) + name,
          kCoordinates, this);
      field->setSuffix(QStringLiteral(" m"));
      field->setAccessibleName(corner == 0 ? tr("Minimum %1 of the volume of interest").arg(name)
                                           : tr("Maximum %1 of the volume of interest").arg(name));
      field->setToolTip(corner == 0 ? tr("Smallest x, y and z of the volume of interest, in "
                                         "meters. Targets are searched for only inside this box")
                                    : tr("Largest x, y and z of the volume of interest, in meters. "
                                         "Targets are searched for only inside this box"));
      grid->addWidget(field, row + 1, static_cast<int>(axis));
      grid->setColumnStretch(static_cast<int>(axis), 1);
      fields_[corner][axis] = field;
    }
    labels[corner]->setBuddy(fields_[corner][0]);
  }
  fromCameras_->setText(tr("Compute from cameras"));
  fromCameras_->setToolTip(
      tr("Search for targets in the box around the region that at least two cameras see"));
  none_->setText(tr("None"));
  none_->setToolTip(tr("Search for targets anywhere"));
  grid->addWidget(fromCameras_, 5, 0, 1, 2);
  grid->addWidget(none_, 5, 2);
}

void VolumeForm::connectFields() {
  for (std::size_t corner = 0; corner < fields_.size(); ++corner) {
    for (std::size_t axis = 0; axis < kAxisLetters.size(); ++axis) {
      connect(fields_[corner][axis], &QDoubleSpinBox::valueChanged, this,
              [this, corner, axis](double meters) {
                setCoordinate(corner, static_cast<int>(axis), meters);
              });
    }
  }
  connect(fromCameras_, &QPushButton::clicked, this, [this] {
    if (const auto seen = setup::volumeSeenByCameras(document_.project())) {
      set(tr("Set volume of interest"), *seen);
    }
  });
  connect(none_, &QPushButton::clicked, this,
          [this] { set(tr("Remove volume of interest"), std::nullopt); });
  connect(&document_, &Document::volumeChanged, this, &VolumeForm::refresh);
  connect(&document_, &Document::calibrationChanged, this, &VolumeForm::refresh);
  connect(&document_, &Document::sourcesChanged, this, &VolumeForm::refresh);
}

std::optional<WorldBox> VolumeForm::shown() const {
  const auto& own = document_.project().volumeOfInterest;
  return own ? own : setup::volumeSeenByCameras(document_.project());
}

void VolumeForm::refresh() {
  const bool isSet = document_.project().volumeOfInterest.has_value();
  const auto volume = shown();
  const WorldBox box = volume.value_or(unitBox());
  for (std::size_t axis = 0; axis < kAxisLetters.size(); ++axis) {
    showValue(*fields_[0][axis], box.min[static_cast<Eigen::Index>(axis)]);
    showValue(*fields_[1][axis], box.max[static_cast<Eigen::Index>(axis)]);
  }
  state_->setText(isSet ? tr("Targets are searched for only inside this box.")
                  : volume
                      ? tr("None: targets are searched for everywhere. The numbers show the region "
                           "that the cameras see; change one of them to search in a box.")
                      : tr("None: targets are searched for anywhere. Change a number to search in "
                           "a box."));
  fromCameras_->setEnabled(isSet || volume);
  none_->setEnabled(isSet);
}

void VolumeForm::setCoordinate(std::size_t corner, int axis, double meters) {
  WorldBox box = shown().value_or(unitBox());
  (corner == 0 ? box.min : box.max)[axis] = meters;
  set(tr("Change volume of interest"), box,
      "volume " + std::to_string(corner) + std::to_string(axis));
}

void VolumeForm::set(const QString& step, const std::optional<WorldBox>& volume,
                     const std::string& mergeKey) {
  const auto edited = document_.edit(
      step, [&](Project& project) { project.volumeOfInterest = volume; }, mergeKey);
  if (!edited) {
    refresh(); // a box turned inside out: show what holds
  }
}

} // namespace dewpoint::ui

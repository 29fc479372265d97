// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/planner/uncertainty_map_form.h"

#include "core/base/units.h"
#include "ui/calibration/planner/rig_planner.h"
#include "ui/text/axis_names.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

namespace dewpoint::ui {
namespace {

constexpr int kHeightSteps = 200;

} // namespace

UncertaintyMapForm::UncertaintyMapForm(RigPlanner& plan, QWidget* parent)
    : QWidget(parent), plan_(plan) {
  setObjectName(QStringLiteral("mapFields"));
  createWidgets();
  connectFields();
  connectVolume();
  onRetranslate(this, [this] { retranslateUi(); });
}

void UncertaintyMapForm::createWidgets() {
  const auto check = [this](const char* name) {
    auto* box = new QCheckBox(this);
    box->setObjectName(QLatin1String(name));
    return box;
  };
  shown_ = check("mapShown");
  summary_ = new QLabel(this);
  summary_->setObjectName(QStringLiteral("mapSummary"));
  summary_->setWordWrap(true);
  quantityLabel_ = new QLabel(this);
  quantity_ = new QComboBox(this);
  quantity_->setObjectName(QStringLiteral("mapQuantity"));
  makeNarrow(*quantity_);
  goodLabel_ = new QLabel(this);
  good_ = makeNumberField(QStringLiteral("mapGood"), {0.01, 10000.0, 1.0, 2}, this);
  pixelLabel_ = new QLabel(this);
  pixel_ = makeNumberField(QStringLiteral("mapPixelSigma"), {0.01, 100.0, 0.1, 2}, this);
  slice_ = check("mapSlice");
  heightSlider_ = new QSlider(Qt::Horizontal, this);
  heightSlider_->setObjectName(QStringLiteral("mapHeightSlider"));
  heightSlider_->setRange(0, kHeightSteps);
  height_ = makeNumberField(QStringLiteral("mapHeight"), {-1e3, 1e3, 0.1, 3}, this);
  volume_ = check("mapVolume");
  lowLabel_ = new QLabel(this);
  highLabel_ = new QLabel(this);
  room_ = new QPushButton(this);
  room_->setObjectName(QStringLiteral("mapRoom"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  for (int column = 0; column < 3; ++column) {
    grid->setColumnStretch(column, 1);
  }
  grid->addWidget(shown_, 0, 0, 1, 3);
  grid->addWidget(summary_, 1, 0, 1, 3);
  grid->addWidget(quantityLabel_, 2, 0);
  grid->addWidget(quantity_, 2, 1, 1, 2);
  grid->addWidget(goodLabel_, 3, 0, 1, 2);
  grid->addWidget(good_, 3, 2);
  grid->addWidget(pixelLabel_, 4, 0, 1, 2);
  grid->addWidget(pixel_, 4, 2);
  grid->addWidget(slice_, 5, 0);
  grid->addWidget(heightSlider_, 5, 1);
  grid->addWidget(height_, 5, 2);
  grid->addWidget(volume_, 6, 0, 1, 3);
  grid->addWidget(lowLabel_, 7, 0, 1, 3);
  grid->addWidget(highLabel_, 9, 0, 1, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const QString axis = QLatin1String(kAxisLetters[k]);
    low_[k] = makeNumberField(QStringLiteral("mapLow") + axis, {-1e3, 1e3, 0.1, 3}, this);
    high_[k] = makeNumberField(QStringLiteral("mapHigh") + axis, {-1e3, 1e3, 0.1, 3}, this);
    grid->addWidget(low_[k], 8, static_cast<int>(k));
    grid->addWidget(high_[k], 10, static_cast<int>(k));
  }
  grid->addWidget(room_, 11, 1, 1, 2);
  quantityLabel_->setBuddy(quantity_);
  goodLabel_->setBuddy(good_);
  pixelLabel_->setBuddy(pixel_);
  lowLabel_->setBuddy(low_[0]);
  highLabel_->setBuddy(high_[0]);
}

void UncertaintyMapForm::connectFields() {
  connect(&plan_, &RigPlanner::changed, this, &UncertaintyMapForm::refresh);
  connect(&plan_, &RigPlanner::mapChanged, this, &UncertaintyMapForm::summarize);
  connect(shown_, &QCheckBox::toggled, &plan_, &RigPlanner::setMapShown);
  const auto edit = [this](auto change) {
    return [this, change](auto value) {
      MapOptions look = plan_.mapOptions();
      change(look, value);
      plan_.setMapOptions(look);
    };
  };
  connect(quantity_, &QComboBox::activated, this, edit([](MapOptions& look, int index) {
            look.quantity = index == 1 ? MapQuantity::CameraCount : MapQuantity::Sigma;
          }));
  connect(good_, &QDoubleSpinBox::valueChanged, this,
          edit([](MapOptions& look, double value) { look.maxGoodSigma = fromMillimeters(value); }));
  connect(slice_, &QCheckBox::toggled, this,
          edit([](MapOptions& look, bool shown) { look.showsLayer = shown; }));
  connect(volume_, &QCheckBox::toggled, this,
          edit([](MapOptions& look, bool shown) { look.showsVolume = shown; }));
  connect(height_, &QDoubleSpinBox::valueChanged, this,
          edit([](MapOptions& look, double value) { look.layerHeight = value; }));
  connect(heightSlider_, &QSlider::valueChanged, this, edit([this](MapOptions& look, int step) {
            const double low = plan_.volume().min().z();
            look.layerHeight = low + (plan_.volume().max().z() - low) * step / kHeightSteps;
          }));
  connect(pixel_, &QDoubleSpinBox::valueChanged, &plan_, &RigPlanner::setPixelSigma);
}

void UncertaintyMapForm::connectVolume() {
  for (int k = 0; k < 3; ++k) {
    connect(low_[std::size_t(k)], &QDoubleSpinBox::valueChanged, this, [this, k](double value) {
      Eigen::AlignedBox3d box = plan_.volume();
      box.min()[k] = value;
      plan_.setVolume(box);
    });
    connect(high_[std::size_t(k)], &QDoubleSpinBox::valueChanged, this, [this, k](double value) {
      Eigen::AlignedBox3d box = plan_.volume();
      box.max()[k] = value;
      plan_.setVolume(box);
    });
  }
  connect(room_, &QPushButton::clicked, &plan_, &RigPlanner::followProjectVolume);
}

void UncertaintyMapForm::retranslateUi() {
  const auto name = [](QWidget* field, const QString& text, const QString& tip) {
    field->setAccessibleName(text);
    field->setToolTip(tip);
  };
  shown_->setText(tr("Show the map in the bird's-eye view"));
  shown_->setToolTip(tr("Show the position error to expect for a target at each point. The map "
                        "changes whenever a camera moves"));
  quantityLabel_->setText(tr("Colors show"));
  {
    const QSignalBlocker quiet(quantity_);
    quantity_->clear();
    quantity_->addItems({tr("the expected error"), tr("the number of cameras")});
  }
  name(quantity_, tr("Meaning of the colors"),
       tr("The expected error (standard deviation in the worst direction), or the number of "
          "cameras that see a point"));
  goodLabel_->setText(tr("Acceptable error"));
  name(good_, tr("Acceptable error"),
       tr("Errors up to this value are blue in the map. The summary and the search for a camera "
          "position also use this value"));
  good_->setSuffix(QStringLiteral(" mm"));
  pixelLabel_->setText(tr("Detection error"));
  name(pixel_, tr("Detection error"),
       tr("Error of a target's position in an image, in pixels (one standard deviation)"));
  pixel_->setSuffix(QStringLiteral(" px"));
  slice_->setText(tr("Layer at"));
  slice_->setToolTip(tr("Show the map in a horizontal layer"));
  name(heightSlider_, tr("Height of the layer above the floor"),
       tr("Height of the layer above the floor"));
  name(height_, tr("Height of the layer above the floor, in meters"),
       tr("Height of the layer above the floor"));
  height_->setSuffix(QStringLiteral(" m"));
  volume_->setText(tr("Surfaces around good and fair regions"));
  volume_->setToolTip(tr("Show surfaces in the room. For the error: around the regions with at "
                         "most 0.4, 1 and 2 times the acceptable error. For the number of cameras: "
                         "around the regions that two, three and four cameras see"));
  lowLabel_->setText(tr("Volume: minimum x, y, z"));
  highLabel_->setText(tr("Volume: maximum x, y, z"));
  for (std::size_t k = 0; k < 3; ++k) {
    const QString axis = QLatin1String(kAxisLetters[k]);
    name(low_[k], tr("Minimum %1 of the map's volume").arg(axis),
         tr("Smallest x, y and z of the volume, in meters"));
    name(high_[k], tr("Maximum %1 of the map's volume").arg(axis),
         tr("Largest x, y and z of the volume, in meters"));
    low_[k]->setSuffix(QStringLiteral(" m"));
    high_[k]->setSuffix(QStringLiteral(" m"));
  }
  room_->setText(tr("Set from reference grid"));
  room_->setToolTip(tr("Use the volume above the reference grid, up to the highest camera"));
  refresh();
  summarize();
}

void UncertaintyMapForm::refresh() {
  const auto tick = [](QCheckBox& box, bool on) {
    const QSignalBlocker quiet(box);
    box.setChecked(on);
  };
  const MapOptions& look = plan_.mapOptions();
  const Eigen::AlignedBox3d& box = plan_.volume();
  tick(*shown_, plan_.isMapShown());
  tick(*slice_, look.showsLayer);
  tick(*volume_, look.showsVolume);
  quantity_->setCurrentIndex(look.quantity == MapQuantity::CameraCount ? 1 : 0);
  showValue(*good_, inMillimeters(look.maxGoodSigma));
  showValue(*pixel_, plan_.pixelSigma());
  showValue(*height_, look.layerHeight);
  {
    const QSignalBlocker quiet(heightSlider_);
    const double share = (look.layerHeight - box.min().z()) / box.sizes().z();
    heightSlider_->setValue(static_cast<int>(std::lround(kHeightSteps * share)));
  }
  for (int k = 0; k < 3; ++k) {
    showValue(*low_[std::size_t(k)], box.min()[k]);
    showValue(*high_[std::size_t(k)], box.max()[k]);
  }
  room_->setEnabled(!plan_.followsProjectVolume());
  summarize();
}

void UncertaintyMapForm::summarize() {
  QString text;
  if (plan_.isMapShown() && plan_.map()) {
    const RigMapSummary summary = summaryOf(*plan_.map(), plan_.mapOptions().maxGoodSigma);
    text = tr("The error is at most %2 in %1 of the volume. Fewer than two cameras see %3 of the "
              "volume")
               .arg(percentText(summary.fractionWithinLimit),
                    lengthText(plan_.mapOptions().maxGoodSigma, LengthForm::Short),
                    percentText(summary.fractionSeenByTooFew));
  }
  summary_->setText(text);
  summary_->setVisible(!text.isEmpty());
}

} // namespace dewpoint::ui

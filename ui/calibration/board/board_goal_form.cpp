// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/board_goal_form.h"

#include "core/base/units.h"
#include "ui/calibration/board/board_calibrator.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include <array>
#include <limits>

namespace dewpoint::ui {
namespace {

/// In the order of the choice.
constexpr std::array<BoardGoal, 3> kGoals{{{true, true}, {true, false}, {false, true}}};

} // namespace

BoardGoalForm::BoardGoalForm(BoardCalibrator& calibrator, QWidget* parent)
    : QWidget(parent), calibrator_(calibrator) {
  setObjectName(QStringLiteral("boardGoalFields"));
  createWidgets();
  connectFields();
  onRetranslate(this, [this] { retranslateUi(); });
}

void BoardGoalForm::createWidgets() {
  const auto combo = [this](const char* name) {
    auto* box = new QComboBox(this);
    box->setObjectName(QLatin1String(name));
    makeNarrow(*box);
    return box;
  };
  goalLabel_ = new QLabel(this);
  goal_ = combo("boardGoal");
  modelLabel_ = new QLabel(this);
  model_ = combo("boardModel");
  floor_ = new QCheckBox(this);
  floor_->setObjectName(QStringLiteral("boardFloor"));
  floorFrame_ = new QSpinBox(this);
  floorFrame_->setObjectName(QStringLiteral("boardFloorFrame"));
  floorFrame_->setRange(1, std::numeric_limits<int>::max()); // counted as in the timeline
  floorFrame_->setKeyboardTracking(false);
  floorHere_ = new QPushButton(this);
  floorHere_->setObjectName(QStringLiteral("boardFloorHere"));
  accuracyLabel_ = new QLabel(this);
  lensAccuracy_ = makeNumberField(QStringLiteral("boardLensAccuracy"), {0.05, 20.0, 0.05, 2}, this);
  positionAccuracy_ =
      makeNumberField(QStringLiteral("boardPlaceAccuracy"), {0.05, 100.0, 0.5, 2}, this);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  for (int column = 0; column < 3; ++column) {
    grid->setColumnStretch(column, 1);
  }
  grid->addWidget(goalLabel_, 0, 0);
  grid->addWidget(goal_, 0, 1, 1, 2);
  grid->addWidget(modelLabel_, 1, 0);
  grid->addWidget(model_, 1, 1, 1, 2);
  grid->addWidget(floor_, 2, 0, 1, 3);
  grid->addWidget(floorFrame_, 3, 1);
  grid->addWidget(floorHere_, 3, 2);
  grid->addWidget(accuracyLabel_, 4, 0);
  grid->addWidget(lensAccuracy_, 4, 1);
  grid->addWidget(positionAccuracy_, 4, 2);
  goalLabel_->setBuddy(goal_);
  modelLabel_->setBuddy(model_);
  accuracyLabel_->setBuddy(lensAccuracy_);
}

void BoardGoalForm::edit(const std::function<void(BoardGuideRequest&)>& change) {
  BoardGuideRequest request = calibrator_.guideRequest();
  change(request);
  calibrator_.setGuideRequest(request);
}

void BoardGoalForm::connectFields() {
  connect(&calibrator_, &BoardCalibrator::guideRequestChanged, this, &BoardGoalForm::refresh);
  connect(&calibrator_, &BoardCalibrator::changed, this, &BoardGoalForm::refresh);
  connect(goal_, &QComboBox::activated, this, [this](int index) {
    edit([index](BoardGuideRequest& request) {
      request.goal = kGoals.at(static_cast<std::size_t>(index));
    });
  });
  connect(model_, &QComboBox::activated, this, [this](int index) {
    edit([index](BoardGuideRequest& request) {
      request.board.model = static_cast<IntrinsicsModel>(index);
    });
  });
  connect(floor_, &QCheckBox::clicked, this, [this](bool on) {
    edit([&](BoardGuideRequest& request) {
      request.board.floorFrame =
          on ? std::optional<std::int64_t>(floorFrame_->value() - 1) : std::nullopt;
    });
  });
  connect(floorFrame_, &QSpinBox::valueChanged, this, [this](int frame) {
    edit([frame](BoardGuideRequest& request) { request.board.floorFrame = frame - 1; });
  });
  connect(floorHere_, &QPushButton::clicked, this, [this] {
    edit([this](BoardGuideRequest& request) {
      request.board.floorFrame = calibrator_.shownFrame();
    });
  });
  connect(lensAccuracy_, &QDoubleSpinBox::valueChanged, this, [this](double pixels) {
    edit([pixels](BoardGuideRequest& request) {
      request.lensGuidance.requiredProjectionSigmaPx = pixels;
    });
  });
  connect(positionAccuracy_, &QDoubleSpinBox::valueChanged, this, [this](double millimeters) {
    edit([=](BoardGuideRequest& request) {
      request.requiredPositionSigma = fromMillimeters(millimeters);
    });
  });
}

void BoardGoalForm::retranslateUi() {
  const auto name = [](QWidget* field, const QString& text, const QString& tip) {
    field->setAccessibleName(text);
    field->setToolTip(tip);
  };
  const auto fill = [](QComboBox* box, const QStringList& items) {
    const QSignalBlocker quiet(box);
    box->clear();
    box->addItems(items);
  };
  goalLabel_->setText(tr("Find"));
  fill(goal_, {tr("Intrinsics and positions"), tr("Intrinsics"), tr("Camera positions")});
  name(goal_, tr("Values to calibrate"),
       tr("Intrinsics: lens and sensor, for each camera separately. Positions: where the cameras "
          "are, computed from a board that several cameras see at the same time"));
  modelLabel_->setText(tr("Lens model"));
  fill(model_,
       {tr("Pinhole, 5 coefficients"), tr("Pinhole, 8 coefficients (wide)"), tr("Fisheye")});
  name(model_, tr("Lens model"),
       tr("5 coefficients for most lenses, 8 for wide-angle lenses, fisheye for a field of view "
          "above about 120°"));
  floor_->setText(tr("Frame with the board on the floor"));
  floor_->setToolTip(tr("The board as it lies in this video frame defines the world coordinates: X "
                        "along its rows, Y toward its upper edge, Z up from the floor. Without "
                        "such a frame, the first camera keeps its position"));
  name(floorFrame_, tr("Number of the frame with the board on the floor"),
       tr("Number of the frame, as in the timeline (the first frame is 1)"));
  floorHere_->setText(tr("Set to current frame"));
  name(floorHere_, tr("Set floor frame to current frame"),
       tr("Enter the number of the frame that is shown now"));
  accuracyLabel_->setText(tr("Accuracy goal"));
  name(lensAccuracy_, tr("Desired accuracy of the intrinsics"),
       tr("Guidance ends when the intrinsics are this accurate in all parts of the image"));
  lensAccuracy_->setSuffix(QStringLiteral(" px"));
  name(positionAccuracy_, tr("Desired accuracy of the positions"),
       tr("Guidance ends when the position of each camera is this accurate"));
  positionAccuracy_->setSuffix(QStringLiteral(" mm"));
  refresh();
}

void BoardGoalForm::refresh() {
  const BoardGuideRequest& request = calibrator_.guideRequest();
  for (std::size_t k = 0; k < kGoals.size(); ++k) {
    if (kGoals.at(k) == request.goal) {
      goal_->setCurrentIndex(static_cast<int>(k));
    }
  }
  model_->setCurrentIndex(static_cast<int>(request.board.model));
  modelLabel_->setVisible(request.goal.estimatesLenses);
  model_->setVisible(request.goal.estimatesLenses);
  const bool live = calibrator_.usesLiveCameras();
  const bool onFloor = request.board.floorFrame.has_value();
  floor_->setChecked(onFloor);
  floor_->setVisible(!live && request.goal.estimatesPoses);
  floorFrame_->setVisible(onFloor && floor_->isVisibleTo(this));
  floorHere_->setVisible(onFloor && floor_->isVisibleTo(this));
  floorHere_->setEnabled(calibrator_.shownFrame() >= 0);
  {
    const QSignalBlocker quiet(floorFrame_);
    floorFrame_->setValue(static_cast<int>(request.board.floorFrame.value_or(0)) + 1);
  }
  accuracyLabel_->setVisible(live);
  lensAccuracy_->setVisible(live && request.goal.estimatesLenses);
  positionAccuracy_->setVisible(live && request.goal.estimatesPoses);
  showValue(*lensAccuracy_, request.lensGuidance.requiredProjectionSigmaPx);
  showValue(*positionAccuracy_, inMillimeters(request.requiredPositionSigma));
}

} // namespace dewpoint::ui

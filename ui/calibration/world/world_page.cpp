// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/world/world_page.h"

#include "core/base/angle.h"
#include "ui/calibration/calibration_dock.h"
#include "ui/calibration/world/board_floor.h"
#include "ui/calibration/world/world_marks.h"
#include "ui/document/camera_list_model.h"
#include "ui/text/axis_names.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/named_widgets.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_title.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {
namespace {

// Meters, meters, degrees. Chosen.
constexpr NumberRange kLength{0.001, 1000.0, 0.01, 4};
constexpr NumberRange kShift{-1000.0, 1000.0, 0.01, 3};
constexpr NumberRange kTurn{-360.0, 360.0, 1.0, 2};

} // namespace

WorldPage::WorldPage(WorldMarks& marks, BoardFloor& boardFloor, const CameraListModel& cameras,
                     QWidget* parent)
    : QWidget(parent), marks_(marks), boardFloor_(boardFloor), cameras_(cameras) {
  setObjectName(QStringLiteral("worldPage"));
  build();
  connectFields();
  onRetranslate(this, [this] { retranslateUi(); });
}

void WorldPage::build() {
  guide_ = new QLabel(this);
  guide_->setWordWrap(true);
  uprightText_ = new QLabel(this);
  uprightText_->setObjectName(QStringLiteral("worldUprightText"));
  uprightText_->setWordWrap(true);
  marksTitle_ = makePageTitle(this);
  table_ = new QTableWidget(WorldMarks::kMarkCount, ColumnCount, this);
  table_->setObjectName(QStringLiteral("worldMarks"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(Point, QHeaderView::Stretch);
  table_->setTabKeyNavigation(false); // Tab goes on to the buttons
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  mark_ = makeButton("worldMark", this);
  mark_->setCheckable(true);
  clear_ = makeButton("worldClear", this);
  worldTitle_ = makePageTitle(this);
  distanceLabel_ = new QLabel(this);
  distance_ = makeNumberField(QStringLiteral("worldDistance"), kLength, this);
  distanceLabel_->setBuddy(distance_);
  check_ = makeButton("worldCheck", this);
  resultText_ = new QLabel(this);
  resultText_->setObjectName(QStringLiteral("worldResult"));
  resultText_->setWordWrap(true);
  resultText_->setProperty(kRevealedProperty, true);
  resultText_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  board_ = makeButton("worldBoard", this);
  boardText_ = new QLabel(this);
  boardText_->setObjectName(QStringLiteral("worldBoardText"));
  boardText_->setWordWrap(true);
  for (const auto& [step, name] :
       {std::pair(WorldStep::Upright, "worldUpright"), std::pair(WorldStep::Floor, "worldFloor"),
        std::pair(WorldStep::Level, "worldLevel"), std::pair(WorldStep::Origin, "worldOrigin"),
        std::pair(WorldStep::XAxis, "worldXAxis"), std::pair(WorldStep::Length, "worldLength")}) {
    steps_.emplace_back(step, makeButton(name, this));
  }
  const auto buttonOf = [this](WorldStep step) {
    return std::ranges::find(steps_, step, &std::pair<WorldStep, QPushButton*>::first)->second;
  };
  auto* marking = new QGridLayout;
  marking->setSpacing(6);
  marking->addWidget(mark_, 0, 0);
  marking->addWidget(clear_, 0, 1);
  auto* world = new QGridLayout;
  world->setSpacing(6);
  world->addWidget(buttonOf(WorldStep::Floor), 0, 0, 1, 2);
  world->addWidget(buttonOf(WorldStep::Origin), 1, 0);
  world->addWidget(buttonOf(WorldStep::XAxis), 1, 1);
  world->addWidget(buttonOf(WorldStep::Level), 2, 0, 1, 2);
  world->addWidget(distanceLabel_, 3, 0, 1, 2);
  world->addWidget(distance_, 4, 0, 1, 2);
  world->addWidget(check_, 5, 0);
  world->addWidget(buttonOf(WorldStep::Length), 5, 1);
  world->setColumnStretch(0, 1);
  world->setColumnStretch(1, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(guide_);
  column->addWidget(uprightText_);
  column->addWidget(buttonOf(WorldStep::Upright));
  column->addWidget(marksTitle_);
  column->addWidget(table_);
  column->addLayout(marking);
  column->addWidget(worldTitle_);
  column->addLayout(world);
  column->addWidget(resultText_);
  column->addWidget(board_);
  column->addWidget(boardText_);
  column->addWidget(makeMove());
  column->addStretch(1);
}

QWidget* WorldPage::makeMove() {
  auto* part = new QWidget(this);
  moveTitle_ = makePageTitle(part);
  auto* grid = new QGridLayout(part);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  grid->addWidget(moveTitle_, 0, 0, 1, 4);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    shift_[axis] = makeNumberField(QStringLiteral("worldShift") + QLatin1String(kAxisLetters[axis]),
                                   kShift, part);
    grid->addWidget(shift_[axis], 1, static_cast<int>(axis));
  }
  turn_ = makeNumberField(QStringLiteral("worldTurn"), kTurn, part);
  grid->addWidget(turn_, 1, 3);
  move_ = makeButton("worldMove", part);
  grid->addWidget(move_, 2, 0, 1, 4);
  quarterLabel_ = new QLabel(part);
  grid->addWidget(quarterLabel_, 3, 0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    quarters_[axis] = new QPushButton(part);
    quarters_[axis]->setObjectName(QStringLiteral("worldQuarter") +
                                   QLatin1String(kAxisLetters[axis]));
    quarters_[axis]->setMinimumWidth(0);
    grid->addWidget(quarters_[axis], 3, static_cast<int>(axis) + 1);
  }
  for (int k = 0; k < 4; ++k) {
    grid->setColumnStretch(k, 1);
  }
  return part;
}

void WorldPage::connectFields() {
  connect(&marks_, &WorldMarks::changed, this, &WorldPage::refresh);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (!filling_ && row >= 0) {
      marks_.selectMark(row);
    }
  });
  connect(mark_, &QPushButton::clicked, &marks_, &WorldMarks::setClicksPlacePoint);
  connect(clear_, &QPushButton::clicked, &marks_, &WorldMarks::clearClicks);
  connect(board_, &QPushButton::clicked, &boardFloor_, &BoardFloor::setFloorFromBoard);
  connect(&boardFloor_, &BoardFloor::changed, this, &WorldPage::refresh);
  connect(distance_, &QDoubleSpinBox::valueChanged, this, [this] { distanceEntered_ = true; });
  connect(check_, &QPushButton::clicked, this,
          [this] { marks_.storeLengthCheck(distance_->value()); });
  for (const auto& [step, button] : steps_) {
    connect(button, &QPushButton::clicked, this,
            [this, step = step] { marks_.apply(step, distance_->value()); });
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    connect(quarters_[axis], &QPushButton::clicked, this,
            [this, axis] { marks_.rotateWorld(static_cast<WorldAxis>(axis)); });
  }
  connect(move_, &QPushButton::clicked, this, [this] {
    marks_.moveWorld({shift_[0]->value(), shift_[1]->value(), shift_[2]->value()},
                     turn_->value() * base::kDegree);
    for (QDoubleSpinBox* field : {shift_[0], shift_[1], shift_[2], turn_}) {
      showValue(*field, 0.0); // a second press does not move them again
    }
  });
}

void WorldPage::retranslateUi() {
  const auto name = [](QWidget* widget, const QString& text, const QString& tip) {
    widget->setAccessibleName(text);
    widget->setToolTip(tip);
  };
  const auto button = [&](QPushButton* one, const QString& text, const QString& tip) {
    one->setText(text);
    name(one, text, tip);
  };
  guide_->setText(tr("Set the floor, the origin and the scale of the room. The cameras keep their "
                     "positions relative to each other."));
  uprightText_->setText(tr("⚠ The z axis does not seem to point up."));
  marksTitle_->setText(tr("Points"));
  table_->setHorizontalHeaderLabels(
      {tr("Point"), tr("marked"), tr("x m"), tr("y m"), tr("z m"), tr("± mm")});
  name(table_, tr("Points"),
       tr("Points of the room that you mark in the images, and their positions. ± is one standard "
          "deviation of a position, if clicks are accurate to 2 px."));
  button(clear_, tr("Remove marks"), tr("Remove the marks of A, B and C from all images"));
  worldTitle_->setText(tr("Floor, origin and scale"));
  distanceLabel_->setText(tr("Measured distance from A to B"));
  setRange(*distance_, kLength, tr(" m"));
  name(distance_, tr("Measured distance from A to B"),
       tr("The distance that you measured in the room, in meters"));
  button(check_, tr("Check"),
         tr("Compare the distance from A to B in the calibration with the distance that you "
            "measured. Nothing is changed."));
  button(board_, tr("Set floor from the board shown"),
         tr("Use a board that lies flat on the floor in the images shown. Its first corner becomes "
            "the origin, and the x axis runs along its rows. Describe the board on the page "
            "Board."));
  for (const auto& [step, one] : steps_) {
    switch (step) {
    case WorldStep::Upright:
      button(one, tr("Turn upright"),
             tr("Rotate the world by quarter turns until its upward direction points up in the "
                "images"));
      break;
    case WorldStep::Floor:
      button(one, tr("Set floor from A, B and C"),
             tr("The floor goes through A, B and C. A becomes the origin, and the x axis points "
                "to B."));
      break;
    case WorldStep::Level:
      button(one, tr("Make line A–B level"),
             tr("Rotate the world by the smallest angle that makes this line horizontal"));
      break;
    case WorldStep::Origin:
      button(one, tr("Origin at A"), tr("Move the origin to A; the axes keep their directions"));
      break;
    case WorldStep::XAxis:
      button(one, tr("x axis along A–B"),
             tr("Rotate the world about the vertical until the x axis points from A to B"));
      break;
    case WorldStep::Length:
      button(one, tr("Set scale"),
             tr("Multiply all lengths by one factor, so that the distance from A to B is the "
                "measured one"));
      break;
    }
  }
  moveTitle_->setText(tr("Move all cameras together"));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const QString letter = QString(QLatin1String(kAxisLetters[axis])).toLower();
    setRange(*shift_[axis], kShift, tr(" m"));
    name(shift_[axis], tr("Shift of all cameras along %1").arg(letter),
         tr("How far all cameras move along %1, in meters").arg(letter));
    button(quarters_[axis], letter,
           tr("Rotate all cameras by 90° about the %1 axis, counterclockwise if the axis points "
              "toward you")
               .arg(letter));
    quarters_[axis]->setAccessibleName(tr("Quarter turn about %1").arg(letter));
  }
  setRange(*turn_, kTurn, tr("°"));
  name(turn_, tr("Rotation of all cameras about the vertical axis"),
       tr("Angle by which all cameras rotate about the vertical through the origin, "
          "counterclockwise as seen from above. The cameras are rotated first and then moved"));
  button(move_, tr("Move"), tr("Rotate and move all cameras together"));
  quarterLabel_->setText(tr("Quarter turn"));
  refresh();
}

void WorldPage::fillRow(int mark) {
  static const std::array<const char*, WorldMarks::kMarkCount> kUses{
      QT_TR_NOOP("A: origin"), QT_TR_NOOP("B: on the x axis"), QT_TR_NOOP("C: on the floor")};
  const auto position = marks_.positionOf(mark);
  const auto set = [&](int column, const QString& text) {
    QTableWidgetItem* item = table_->item(mark, column);
    if (item == nullptr) {
      item = new QTableWidgetItem;
      table_->setItem(mark, column, item);
    }
    item->setText(text);
    item->setTextAlignment(column == Point ? Qt::AlignLeft | Qt::AlignVCenter
                                           : Qt::AlignRight | Qt::AlignVCenter);
  };
  set(Point, tr(kUses[static_cast<std::size_t>(mark)]));
  set(Seen, QStringLiteral("%1/%2").arg(marks_.clicks(mark).size()).arg(cameras_.rowCount()));
  for (int axis = 0; axis < 3; ++axis) {
    set(X + axis,
        position ? lengthNumber(position->mean[axis], LengthScale::Meters, 3, NumberForm::Rounded)
                 : QStringLiteral("–"));
  }
  set(Accuracy, position ? lengthNumber(std::sqrt(position->covariance.trace() / 3.0),
                                        LengthScale::Millimeters, 1)
                         : QStringLiteral("–"));
}

void WorldPage::refresh() {
  filling_ = true;
  for (int mark = 0; mark < WorldMarks::kMarkCount; ++mark) {
    fillRow(mark);
  }
  if (table_->currentRow() != marks_.selectedMark()) {
    table_->setCurrentCell(marks_.selectedMark(), Point);
  }
  int height = table_->horizontalHeader()->sizeHint().height() + 2 * table_->frameWidth();
  for (int mark = 0; mark < WorldMarks::kMarkCount; ++mark) {
    height += table_->rowHeight(mark);
  }
  table_->setFixedHeight(height);
  filling_ = false;
  mark_->setChecked(marks_.clicksPlacePoint());
  // A shape as well: dark themes hardly show a pressed button.
  mark_->setText((marks_.clicksPlacePoint() ? QStringLiteral("● ") : QString()) +
                 tr("Mark in images"));
  mark_->setAccessibleName(tr("Mark in images"));
  mark_->setToolTip(
      tr("Click the selected point in two or more images. Near a corner, the click moves exactly "
         "onto the corner; hold Alt to prevent this. Press Esc to finish."));
  for (const auto& [step, button] : steps_) {
    button->setEnabled(marks_.canApply(step));
    if (step == WorldStep::Upright) {
      button->setVisible(marks_.canRotateUpright());
    }
  }
  check_->setEnabled(marks_.canApply(WorldStep::Length));
  board_->setEnabled(boardFloor_.canSetFloor());
  boardText_->setText(boardFloor_.resultText());
  boardText_->setVisible(!boardFloor_.resultText().isEmpty());
  uprightText_->setVisible(marks_.canRotateUpright());
  const auto distance = marks_.distanceAB();
  distanceEntered_ = distanceEntered_ && distance;
  if (distance && !distanceEntered_) {
    showValue(*distance_, *distance);
  }
  resultText_->setText(marks_.resultText());
  resultText_->setVisible(!marks_.resultText().isEmpty());
}

} // namespace dewpoint::ui

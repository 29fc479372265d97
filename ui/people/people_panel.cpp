// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/people_panel.h"

#include "core/session/snapshot/snapshot_state.h"
#include "ui/document/method_presentation.h"
#include "ui/selection/selection.h"
#include "ui/style/theme.h"
#include "ui/text/people_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/reason_text.h"
#include "ui/text/retranslation.h"
#include "ui/text/tracking_state_text.h"
#include "ui/widgets/named_widgets.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QProgressBar>
#include <QScopedValueRollback>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

enum Column : int {
  kPerson,
  kPlace,
  kHeight,
  kSpeed,
  kCameras,
  kVolume,
  kSince,
  kNear,
  kPersonColumns,
};
constexpr qint64 kRefreshMs = 150; ///< numbers that change faster are not read

} // namespace

PeoplePanel::PeoplePanel(Selection& selection, QAction* place, QAction* remove, QWidget* parent)
    : QWidget(parent), selection_(selection), summary_(new QLabel(this)),
      learning_(new QProgressBar(this)), table_(new QTableWidget(0, kPersonColumns, this)),
      place_(new QToolButton(this)), remove_(new QToolButton(this)) {
  setObjectName(QStringLiteral("peoplePanel"));
  summary_->setObjectName(QStringLiteral("peopleSummary"));
  summary_->setWordWrap(true);
  learning_->setObjectName(QStringLiteral("learningProgress"));
  learning_->setRange(0, 100);
  learning_->setMaximumHeight(14);
  learning_->setTextVisible(false);
  makeTable();
  for (const auto& [button, action] : {std::pair(place_, place), std::pair(remove_, remove)}) {
    button->setDefaultAction(action);
    button->setObjectName(action->objectName() + QStringLiteral("PanelButton"));
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(summary_);
  column->addWidget(learning_);
  column->addWidget(table_, 1);
  column->addWidget(place_);
  column->addWidget(remove_);
  onRetranslate(this, [this] { retranslateUi(); });
  connect(&selection_, &Selection::targetSelected, this, &PeoplePanel::selectRow);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (!following_ && row >= 0) {
      selection_.selectTarget(table_->item(row, kPerson)->data(Qt::UserRole).toInt() - 1);
    }
  });
}

void PeoplePanel::makeTable() {
  table_->setObjectName(QStringLiteral("peopleTable"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setAlternatingRowColors(true);
  table_->setShowGrid(false);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setWordWrap(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 8);
  table_->horizontalHeader()->setMinimumSectionSize(20);
  QFont small = table_->horizontalHeader()->font();
  small.setPointSizeF(0.9 * small.pointSizeF());
  table_->horizontalHeader()->setFont(small);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kNear, QHeaderView::Stretch);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
}

void PeoplePanel::retranslateUi() {
  table_->setAccessibleName(tr("People in view"));
  learning_->setAccessibleName(tr("Progress of learning the background"));
  const std::pair<QString, QString> headers[kPersonColumns] = {
      {tr("No."), tr("Number of the person. No other person gets the same number in this run")},
      {tr("Position"), tr("Position on the floor, x and y in meters")},
      {tr("Height"), tr("Estimated height in meters; empty if the method does not estimate it")},
      {tr("Speed"), tr("Speed over the floor, in meters per second")},
      {tr("Cameras"), tr("Number of cameras that see the person, out of all cameras")},
      {tr("Volume"), tr("Volume of the hull that encloses 95 % of the person, in cubic meters. "
                        "Empty unless “Show 3D shapes of people” is on")},
      {tr("Time"), tr("Time since the person entered, in seconds")},
      {tr("Near"), tr("● means that another person is close. Until the two are apart again, the "
                      "method learns nothing new about the colors of this person")},
  };
  for (int column = 0; column < kPersonColumns; ++column) {
    auto* item = new QTableWidgetItem(headers[column].first);
    item->setToolTip(headers[column].second);
    table_->setHorizontalHeaderItem(column, item);
  }
  refresh();
}

void PeoplePanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  const bool isAwayFromLiveFrame = !snapshot_ || !snapshot ||
                                   snapshot->state != PlayState::Playing ||
                                   snapshot_->targets.size() != snapshot->targets.size();
  snapshot_ = snapshot;
  if (isAwayFromLiveFrame || !sinceRefresh_.isValid() || sinceRefresh_.elapsed() >= kRefreshMs) {
    refresh();
  }
}

int PeoplePanel::chosenPerson() const {
  const int row = table_->currentRow();
  return row < 0 ? 0 : table_->item(row, kPerson)->data(Qt::UserRole).toInt();
}

void PeoplePanel::showLearning() {
  double least = 1.0;
  for (const PeopleCameraState& camera : snapshot_->peopleCameras) {
    least = std::min(least, camera.learningProgress);
  }
  const bool learns = least < 1.0;
  learning_->setVisible(learns);
  learning_->setValue(static_cast<int>(std::lround(100.0 * least)));
  const int count = peopleCount(*snapshot_);
  summary_->setText(
      learns ? tr("Learning the background: %1 %. Keep the scene empty.").arg(percentNumber(least))
      : count == 0 ? tr("Nobody is in view. People appear when two cameras see them.")
                   : tr("People in view: %1").arg(QLocale().toString(count)));
}

void PeoplePanel::refresh() {
  sinceRefresh_.start();
  if (!snapshot_ || !presentationOf(*snapshot_).listsPeople) {
    learning_->hide();
    summary_->setText(tr("People appear here once a method for people runs."));
    table_->setRowCount(0);
    return;
  }
  showLearning();
  const QScopedValueRollback quiet(following_, true);
  int row = 0;
  for (const PersonInSnapshot& person : peopleIn(*snapshot_)) {
    if (row == table_->rowCount()) {
      table_->insertRow(row);
    }
    showRow(row++, *person.target, *person.estimate);
  }
  table_->setRowCount(row);
  selectRow(selection_.target());
}

void PeoplePanel::setCell(int row, int column, const QString& text, const QString& hint) {
  QTableWidgetItem* item = table_->item(row, column);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    if (column != kPerson) {
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    table_->setItem(row, column, item);
  }
  if (item->text() != text) {
    item->setText(text);
  }
  if (item->toolTip() != hint) {
    item->setToolTip(hint);
  }
}

void PeoplePanel::showRow(int row, const TargetSnapshot& target, const PersonEstimate& person) {
  setCell(row, kPerson, QString::number(person.identity),
          trackingStateText(trackingState(target.status)));
  QTableWidgetItem* first = table_->item(row, kPerson);
  if (first->data(Qt::UserRole).toInt() != person.identity) {
    first->setData(Qt::UserRole, person.identity);
    first->setIcon(makeColorChip(targetColor(target.target.name, person.identity - 1), 12));
    first->setData(Qt::AccessibleTextRole, QString::fromStdString(target.target.name));
  }
  const auto meters = [](double length) {
    return lengthNumber(length, LengthScale::Meters, 2, NumberForm::Rounded);
  };
  setCell(row, kPlace,
          QStringLiteral("%1  %2").arg(meters(person.position.x()), meters(person.position.y())));
  setCell(row, kHeight, person.height > 0.0 ? meters(person.height) : QString());
  setCell(row, kSpeed, numberText(person.velocity.head<2>().norm(), 1, NumberForm::Rounded));
  setCell(
      row, kCameras,
      QStringLiteral("%1/%2").arg(person.seeingCameraCount).arg(snapshot_->peopleCameras.size()));
  setCell(row, kVolume,
          target.shape ? numberText(target.shape->volume, 2, NumberForm::Rounded) : QString());
  setCell(row, kSince, numberText(person.ageSeconds, 0, NumberForm::Rounded));
  setCell(row, kNear, person.isInteracting ? QStringLiteral("●") : QString(),
          person.isInteracting ? tr("Another person is close") : QString());
}

void PeoplePanel::selectRow(int target) {
  const QScopedValueRollback quiet(following_, true);
  for (int row = 0; row < table_->rowCount(); ++row) {
    if (table_->item(row, kPerson)->data(Qt::UserRole).toInt() == target + 1) {
      if (table_->currentRow() != row) {
        table_->setCurrentCell(row, kPerson);
      }
      return;
    }
  }
  table_->setCurrentCell(-1, -1);
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/points/points_table.h"

#include "ui/calibration/calibration_dock.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/calibration/points/point_calibrator.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/named_widgets.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QStyle>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {
namespace {

/// The usual numbers of a column, as wide as they get.
QString usualText(int column) {
  constexpr double kPositionOfTheRoom = -8.888; // meters
  constexpr double kErrorPx = 88.88;
  constexpr double kErrorLength = 0.0888; // meters
  switch (column) {
  case PointsTable::Clicks:
    return QStringLiteral("8/8");
  case PointsTable::Pixels:
    return numberText(kErrorPx, 2);
  case PointsTable::Millimeters:
    return lengthNumber(kErrorLength, LengthScale::Millimeters, 1);
  default:
    return lengthNumber(kPositionOfTheRoom, LengthScale::Meters, 3);
  }
}

int usualWidth(const QTableWidget& table, int column) {
  const int margin = table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &table) + 1;
  return table.fontMetrics().horizontalAdvance(usualText(column)) + 2 * margin + 2;
}

} // namespace

PointsTable::PointsTable(PointCalibrator& points, ManualCalibration& manual, QWidget* parent)
    : QWidget(parent), points_(points), manual_(manual) {
  setObjectName(QStringLiteral("pointsTable"));
  createWidgets();
  connect(&points_, &PointCalibrator::changed, this, &PointsTable::refresh);
  connect(&manual_, &ManualCalibration::cameraSelected, this, &PointsTable::refresh);
  connect(table_, &QTableWidget::cellChanged, this, &PointsTable::edited);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (!filling_) {
      points_.selectPoint(row);
    }
  });
  connect(add_, &QPushButton::clicked, &points_, &PointCalibrator::addPoint);
  connect(remove_, &QPushButton::clicked, &points_, &PointCalibrator::removePoint);
  connect(click_, &QPushButton::clicked, &points_, &PointCalibrator::setClicksPlacePoint);
  connect(forget_, &QPushButton::clicked, this, [this] { points_.removeClick(manual_.camera()); });
  connect(solve_, &QPushButton::clicked, this, [this] {
    points_.setClicksPlacePoint(false); // or the next click in an image would move a point
    points_.solve(focal_->isChecked());
  });
  connect(accept_, &QPushButton::clicked, &points_, &PointCalibrator::acceptProposal);
  onRetranslate(this, [this] { retranslateUi(); });
}

void PointsTable::createWidgets() {
  table_ = new QTableWidget(0, ColumnCount, this);
  table_->setObjectName(QStringLiteral("pointsList"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->verticalHeader()->hide();
  // Columns that follow their contents, or a scroll bar that comes, would move the cell that is
  // edited next.
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  table_->horizontalHeader()->setMinimumSectionSize(28);
  table_->setMinimumHeight(150);
  table_->setTabKeyNavigation(false); // Tab goes on to the buttons
  add_ = makeButton("pointAdd", this);
  remove_ = makeButton("pointRemove", this);
  click_ = makeButton("pointClick", this);
  click_->setCheckable(true);
  forget_ = makeButton("pointForget", this);
  focal_ = new QCheckBox(this);
  focal_->setObjectName(QStringLiteral("pointFocal"));
  solve_ = makeButton("pointSolve", this);
  resultText_ = new QLabel(this);
  resultText_->setObjectName(QStringLiteral("pointAssessment"));
  resultText_->setWordWrap(true);
  resultText_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  resultText_->setProperty(kRevealedProperty, true);
  QSizePolicy policy = resultText_->sizePolicy();
  policy.setRetainSizeWhenHidden(true); // nothing moves when a result comes or goes
  resultText_->setSizePolicy(policy);
  resultText_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  accept_ = makeButton("pointAccept", this);
  auto* buttons = new QGridLayout;
  buttons->setSpacing(6);
  buttons->addWidget(add_, 0, 0);
  buttons->addWidget(remove_, 0, 1);
  buttons->addWidget(click_, 1, 0);
  buttons->addWidget(forget_, 1, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(table_);
  column->addLayout(buttons);
  column->addWidget(focal_);
  column->addWidget(solve_);
  column->addWidget(resultText_);
  column->addWidget(accept_);
}

void PointsTable::retranslateUi() {
  table_->setAccessibleName(tr("Measured points"));
  table_->setToolTip(
      tr("Positions measured with a tape, in meters: double-click to edit. ▲ marks a "
         "point that does not fit the others."));
  table_->setHorizontalHeaderLabels(
      {tr("Point"), tr("x m"), tr("y m"), tr("z m"), tr("clicked"), tr("px"), tr("mm")});
  const auto button = [](QPushButton* one, const QString& text, const QString& tip) {
    one->setText(text);
    one->setAccessibleName(text);
    one->setToolTip(tip);
  };
  button(add_, tr("Add point"), tr("Add a position that you measured in the room"));
  button(remove_, tr("Remove point"), tr("Remove the selected point"));
  button(click_, tr("Click in images"),
         tr("Click the selected point in every image that shows it. Near a corner, the click moves "
            "exactly onto the corner; hold Alt to prevent this. Press Esc to finish."));
  button(forget_, tr("Remove click"),
         tr("Remove the click on the selected point from the image of the selected camera"));
  focal_->setText(tr("Compute focal lengths"));
  focal_->setToolTip(
      tr("Also compute the focal length of each camera in which you clicked six or more points. "
         "Other cameras keep their focal length"));
  button(solve_, tr("Compute cameras"),
         tr("Compute the poses of all cameras in which points were clicked. Each camera needs at "
            "least four points; six that do not all lie in one plane are better"));
  for (int column = X; column < ColumnCount; ++column) {
    table_->setColumnWidth(column, usualWidth(*table_, column));
  }
  refresh();
}

void PointsTable::setCell(int row, int column, const QString& text, bool editable) {
  QTableWidgetItem* item = table_->item(row, column);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    table_->setItem(row, column, item);
  }
  if (item->text() != text) {
    item->setText(text);
  }
  const Qt::ItemFlags shown = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
  item->setFlags(editable ? shown | Qt::ItemIsEditable : shown);
  item->setTextAlignment(column == Name ? Qt::AlignLeft | Qt::AlignVCenter
                                        : Qt::AlignRight | Qt::AlignVCenter);
}

void PointsTable::fillRow(int row) {
  const MeasuredPoint& point = points_.points()[static_cast<std::size_t>(row)];
  const bool isMisfit = points_.misfitPoint() == row;
  const QString name = QString::fromStdString(point.name);
  setCell(row, Name, isMisfit ? QStringLiteral("▲ ") + name : name, true);
  for (int axis = 0; axis < 3; ++axis) {
    setCell(row, X + axis, lengthNumber(point.world[axis], LengthScale::Meters, 3), true);
  }
  setCell(row, Clicks, QStringLiteral("%1/%2").arg(point.clicks.size()).arg(manual_.cameraCount()),
          false);
  QFont font = table_->font();
  font.setBold(isMisfit); // not the numbers: their columns would have to grow
  table_->item(row, Name)->setFont(font);
}

void PointsTable::showResiduals() {
  const auto residuals = points_.residuals();
  for (int row = 0; row < table_->rowCount(); ++row) {
    double pixels = -1.0;
    double meters = -1.0;
    QStringList each;
    for (const ClickResidual& residual : residuals) {
      if (residual.pointIndex == row) {
        pixels = std::max(pixels, residual.imageDistancePx);
        meters = std::max(meters, residual.rayDistance);
        each << tr("%1: %2, %3")
                    .arg(manual_.nameOf(residual.camera), pixelText(residual.imageDistancePx, 2),
                         lengthText(residual.rayDistance, LengthScale::Millimeters, 1));
      }
    }
    setCell(row, Pixels, pixels < 0.0 ? QStringLiteral("–") : numberText(pixels, 2), false);
    setCell(row, Millimeters,
            meters < 0.0 ? QStringLiteral("–") : lengthNumber(meters, LengthScale::Millimeters, 1),
            false);
    for (const int column : {int(Clicks), int(Pixels), int(Millimeters)}) {
      table_->item(row, column)->setToolTip(each.join(QLatin1Char('\n')));
    }
  }
}

/// Columns grow for unusual numbers and never shrink.
void PointsTable::widenColumns() {
  for (int column = X; column < ColumnCount; ++column) {
    const int before = table_->columnWidth(column);
    table_->resizeColumnToContents(column);
    table_->setColumnWidth(column, std::max(before, table_->columnWidth(column)));
  }
}

void PointsTable::showResult() {
  // A line for each camera and one for the worst point; longer results keep the room they took.
  const int usual = (manual_.cameraCount() + 1) * resultText_->fontMetrics().lineSpacing();
  resultText_->setText(points_.resultText());
  resultText_->setMinimumHeight(std::max(
      {usual, resultText_->minimumHeight(), resultText_->heightForWidth(resultText_->width())}));
  resultText_->setVisible(!points_.resultText().isEmpty());
}

void PointsTable::refresh() {
  filling_ = true;
  const int count = static_cast<int>(points_.points().size());
  table_->setRowCount(count);
  for (int row = 0; row < count; ++row) {
    fillRow(row);
  }
  showResiduals();
  widenColumns();
  if (table_->currentRow() != points_.selectedPoint()) {
    table_->setCurrentCell(points_.selectedPoint(), Name);
  }
  filling_ = false;
  const bool any = points_.selectedPoint() >= 0 && points_.selectedPoint() < count;
  remove_->setEnabled(any);
  click_->setEnabled(any);
  click_->setChecked(points_.clicksPlacePoint());
  // A shape as well: dark themes hardly show a pressed button.
  click_->setText((points_.clicksPlacePoint() ? QStringLiteral("● ") : QString()) +
                  tr("Click in images"));
  forget_->setEnabled(any &&
                      findClick(points_.points()[static_cast<std::size_t>(points_.selectedPoint())],
                                manual_.camera()) != nullptr);
  solve_->setEnabled(count > 0 && !points_.isSolving());
  showResult();
  const auto proposed = points_.proposedCamera();
  accept_->setVisible(proposed.has_value());
  if (proposed) {
    accept_->setText(points_.proposalText());
    accept_->setAccessibleName(accept_->text());
    accept_->setToolTip(
        tr("Rotate or mirror the images of this camera and compute its pose again"));
  }
}

void PointsTable::edited(int row, int column) {
  if (filling_ || row >= static_cast<int>(points_.points().size())) {
    return;
  }
  const QString text = table_->item(row, column)->text();
  if (column == Name) {
    const QString mark = QStringLiteral("▲ ");
    points_.renamePoint(row, text.startsWith(mark) ? text.mid(mark.size()) : text);
  } else if (column >= X && column <= Z) {
    bool good = false;
    double value = QLocale().toDouble(text, &good);
    if (!good) {
      value = text.toDouble(&good); // a point where the language has a comma
    }
    if (good) {
      Eigen::Vector3d world = points_.points()[static_cast<std::size_t>(row)].world;
      world[column - X] = value;
      points_.setWorldPosition(row, world);
    }
  }
  refresh(); // also when it was refused
}

} // namespace dewpoint::ui

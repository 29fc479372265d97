// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/target_panel.h"

#include "core/base/overloaded.h"
#include "core/base/units.h"
#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "core/session/snapshot/snapshot_state.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/document/target_list_model.h"
#include "ui/panels/histogram_view.h"
#include "ui/panels/target_row_delegate.h"
#include "ui/style/range_color.h"
#include "ui/style/target_colors.h"
#include "ui/text/quantity_text.h"
#include "ui/text/reason_text.h"
#include "ui/text/retranslation.h"
#include "ui/text/tracking_state_text.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/decimal_field.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>

namespace dewpoint::ui {

namespace {

constexpr double kLargestRadius = 2000.0;
constexpr std::size_t kMostSpeeds = 50; ///< targets whose speed is computed; more cannot be read

QString boxText(const TrackSnapshot& snapshot, const TargetSnapshot& target,
                const BoxEstimate& estimate) {
  const Eigen::Vector2d center = estimate.box.center();
  return TargetPanel::tr(
             "%1, in %2\nCenter %3, %4, size %5 × %6\nSimilarity %7\nEffective sample size %8 of "
             "%9")
             .arg(trackingStateText(trackingState(target)),
                  cameraNames(snapshot).value(estimate.camera), numberText(center.x(), 1),
                  pixelText(center.y()), numberText(estimate.box.width, 1),
                  pixelText(estimate.box.height), numberText(estimate.similarity, 2),
                  numberText(estimate.effectiveSampleSize, 0),
                  QString::number(estimate.particleCount)) +
         QLatin1Char('\n') + TargetPanel::tr("Spread %1").arg(pixelText(estimate.spreadPixels));
}

/// Of a ball, or of a ball of the same volume: as it is given, or else as it was found.
QString radiusText(double given, double found) {
  if (given > 0.0) {
    return TargetPanel::tr("radius %1").arg(lengthText(given, LengthForm::TwoDigits));
  }
  return found > 0.0 ? TargetPanel::tr("radius %1 (estimated)")
                           .arg(lengthText(found, LengthForm::TwoDigits))
                     : TargetPanel::tr("radius unknown");
}

QString sizeText(const Target& target, const TrackEstimate& estimate) {
  const auto radius = [&target](double found) { return radiusText(target.radius, found); };
  return std::visit(Overloaded{[&](const SphereEstimate& sphere) { return radius(sphere.radius); },
                               [](const BoxEstimate& one) {
                                 return TargetPanel::tr("%1 × %2").arg(
                                     numberText(one.box.width, 0), pixelText(one.box.height, 0));
                               },
                               [&](const PersonEstimate&) { return radius(0.0); },
                               [](const AbsentEstimate&) { return QString(); }},
                    estimate);
}

} // namespace

TargetPanel::TargetPanel(Document& document, TargetListModel& targets, QWidget* parent)
    : QWidget(parent), document_(document), list_(new QListView(this)),
      rows_(new TargetRowDelegate(list_)), nameLabel_(new QLabel(this)), name_(new QLineEdit(this)),
      radiusLabel_(new QLabel(this)), radius_(new DecimalField(this)),
      shapeLabel_(new QLabel(this)), shape_(new QComboBox(this)), box_(new QLabel(this)),
      histograms_(new HistogramView(this)), hint_(new QLabel(this)) {
  setObjectName(QStringLiteral("targetPanel"));
  makeFields(targets);
  onRetranslate(this, [this] { retranslateUi(); });
  connect(&document_, &Document::projectReplaced, this, &TargetPanel::refresh);
  connect(&document_, &Document::targetsChanged, this, &TargetPanel::refresh);
  connect(&document_, &Document::methodChanged, this, &TargetPanel::refresh);
  connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
    if (refreshing_) {
      return;
    }
    shown_ = chosenTarget();
    showChosen();
    Q_EMIT targetChosen(shown_);
  });
  connect(name_, &QLineEdit::editingFinished, this, &TargetPanel::rename);
  // The keys go to the window again: Space plays.
  connect(name_, &QLineEdit::returnPressed, name_, &QWidget::clearFocus);
  connect(radius_, &QDoubleSpinBox::valueChanged, this, &TargetPanel::resizeTarget);
  connect(shape_, &QComboBox::activated, this, &TargetPanel::reshapeTarget);
  connect(rows_, &TargetRowDelegate::eyeIconClicked, this, &TargetPanel::toggleTargetShown);
}

void TargetPanel::makeFields(TargetListModel& targets) {
  list_->setObjectName(QStringLiteral("targetList"));
  list_->setModel(&targets);
  list_->setItemDelegate(rows_);
  name_->setObjectName(QStringLiteral("targetName"));
  radius_->setObjectName(QStringLiteral("targetRadius"));
  radius_->setRange(0.0, kLargestRadius);
  radius_->setDecimals(1);
  radius_->setSingleStep(1.0);
  radius_->setKeyboardTracking(false);
  shape_->setObjectName(QStringLiteral("targetShape"));
  shape_->addItems({QString(), QString(), QString()});
  nameLabel_->setBuddy(name_);
  radiusLabel_->setBuddy(radius_);
  shapeLabel_->setBuddy(shape_);
  box_->setObjectName(QStringLiteral("targetBox"));
  box_->setWordWrap(true);
  box_->hide();
  histograms_->hide();
  hint_->setObjectName(QStringLiteral("targetHint"));
  hint_->setWordWrap(true);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  auto* form = new QFormLayout;
  form->setSpacing(8);
  form->addRow(nameLabel_, name_);
  form->addRow(radiusLabel_, radius_);
  form->addRow(shapeLabel_, shape_);
  column_ = new QVBoxLayout(this);
  column_->setContentsMargins(12, 8, 12, 8);
  column_->setSpacing(8);
  column_->addWidget(list_, 1);
  column_->addLayout(form);
  column_->addWidget(box_);
  column_->addWidget(histograms_);
  column_->addWidget(hint_);
}

void TargetPanel::addTools(QAction* add, QAction* remove, QAction* learn) {
  add_ = makeActionButton("targetAdd", add, this);
  remove_ = makeActionButton("targetRemove", remove, this);
  learn_ = makeActionButton("targetLearn", learn, this);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(add_);
  row->addWidget(remove_);
  row->addStretch();
  row->addWidget(learn_);
  column_->insertLayout(0, row);
  retranslateUi();
}

void TargetPanel::retranslateUi() {
  list_->setAccessibleName(tr("Targets"));
  nameLabel_->setText(tr("Name"));
  name_->setToolTip(tr("Target name, as shown in views and files"));
  radiusLabel_->setText(tr("Radius (mm)")); // in the label: "unknown" has no unit
  radius_->setSpecialValueText(tr("unknown"));
  radius_->setToolTip(tr("Radius of the ball, 0 to 2,000 mm. If unknown, it is estimated."));
  shapeLabel_->setText(tr("Shape"));
  shape_->setItemText(0, tr("automatic"));
  shape_->setItemText(1, tr("ball"));
  shape_->setItemText(2, tr("any"));
  shape_->setToolTip(
      tr("Ball: the outline of the target is a circle in every image. Any: the size of the target "
         "is learned, and its position is the center of the region that has its color. Automatic: "
         "the shape is determined from the images. Only method dewpoint uses this setting."));
  refresh();
}

int TargetPanel::chosenTarget() const {
  return list_->currentIndex().row();
}

void TargetPanel::chooseTarget(int target) {
  if (const QModelIndex row = list_->model()->index(target, 0); row.isValid()) {
    list_->setCurrentIndex(row);
  }
}

void TargetPanel::refresh() {
  const auto& targets = document_.project().targets;
  const int before = shown_;
  refreshing_ = true;
  chooseTarget(std::min(std::max(0, before), static_cast<int>(targets.size()) - 1));
  refreshing_ = false;
  shown_ = chosenTarget();
  const bool boxes = document_.methodPresentation().targetsAreBoxes;
  radiusLabel_->setVisible(!boxes);
  radius_->setVisible(!boxes);
  shapeLabel_->setVisible(!boxes);
  shape_->setVisible(!boxes);
  box_->setVisible(boxes);
  histograms_->setVisible(boxes);
  if (add_ != nullptr) {
    add_->setText(tr("Add target"));
    remove_->setText(tr("Remove"));
    learn_->setText(boxes ? tr("Box") : tr("Learn"));
  }
  showChosen();
  showRows();
  if (before > chosenTarget()) { // the chosen one is gone: all others are to show its neighbor, too
    Q_EMIT targetChosen(chosenTarget());
  }
}

QString TargetPanel::hintOf(int row) const {
  const auto& targets = document_.project().targets;
  if (document_.methodPresentation().targetsAreBoxes) {
    return tr("Click the object or drag a box around it in any camera view. It is tracked from "
              "there.");
  }
  if (targets.empty()) {
    return tr("No target yet. In any camera image, click the object to track.");
  }
  const bool isLearned = row >= 0 && !targets[static_cast<std::size_t>(row)].samples.empty();
  return isLearned ? QString()
                   : tr("To learn the color of this target, press Learn and click the target in a "
                        "camera image.");
}

void TargetPanel::showChosen() {
  const int row = chosenTarget();
  hint_->setText(hintOf(row));
  hint_->setVisible(!hint_->text().isEmpty());
  name_->setEnabled(row >= 0);
  radius_->setEnabled(row >= 0);
  shape_->setEnabled(row >= 0);
  const QSignalBlocker quiet(radius_);
  const Target target =
      row < 0 ? Target() : document_.project().targets[static_cast<std::size_t>(row)];
  name_->setText(QString::fromStdString(target.name));
  radius_->setValue(inMillimeters(target.radius));
  shape_->setCurrentIndex(static_cast<int>(target.shape));
}

void TargetPanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  addSpeeds();
  showRows();
  showBox();
}

void TargetPanel::addSpeeds() {
  if (!snapshot_) {
    speeds_.clear();
    return;
  }
  speeds_.resize(std::min(snapshot_->targets.size(), kMostSpeeds));
  for (std::size_t k = 0; k < speeds_.size(); ++k) {
    if (positionOf(snapshot_->targets[k].estimate)) {
      speeds_[k].add(*snapshot_, snapshot_->targets[k]);
    } else {
      speeds_[k].clear();
    }
  }
}

QString TargetPanel::speedTextOf(std::size_t target) const {
  const auto speed = target < speeds_.size() && isConfirmed(snapshot_->targets[target].estimate)
                         ? speeds_[target].metersPerSecond()
                         : std::nullopt;
  return speed ? speedText(*speed) : QString();
}

void TargetPanel::showRows() {
  const auto& targets = document_.project().targets;
  const bool showsColors = !document_.methodPresentation().targetsAreBoxes;
  const std::vector<QColor> colors = targetColors(
      displayColorSources(targets, document_.methodFamily()), displayBackgroundOf(palette()));
  std::vector<TargetRow> rows;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    TargetRow row;
    row.identityColor = colors[k];
    row.isShown = targets[k].isShown;
    if (showsColors) {
      row.learnedColor = rangeColor(targets[k].color);
    }
    const bool isTracked = snapshot_ && k < snapshot_->targets.size();
    row.sizeText = isTracked     ? sizeText(targets[k], snapshot_->targets[k].estimate)
                   : showsColors ? radiusText(targets[k].radius, 0.0)
                                 : QString();
    if (isTracked) {
      row.state = trackingState(snapshot_->targets[k]);
      row.speedText = speedTextOf(k);
    }
    rows.push_back(row);
  }
  if (rows_->setRows(std::move(rows))) {
    list_->viewport()->update();
  }
}

void TargetPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    showRows(); // the colors have a shade for each theme
  }
}

void TargetPanel::showBox() {
  const auto index = static_cast<std::size_t>(std::max(0, chosenTarget()));
  if (!snapshot_ || !presentationOf(*snapshot_).resultsAreBoxes ||
      index >= snapshot_->targets.size()) {
    box_->clear();
    histograms_->setHistograms(nullptr);
    return;
  }
  const TargetSnapshot& target = snapshot_->targets[index];
  histograms_->setHistograms(target.histograms);
  const auto noBox = [] { return tr("No box in this frame."); };
  box_->setText(std::visit(
      Overloaded{[&](const SphereEstimate&) { return noBox(); },
                 [&](const BoxEstimate& box) { return boxText(*snapshot_, target, box); },
                 [&](const PersonEstimate&) { return noBox(); },
                 [&](const AbsentEstimate&) { return noBox(); }},
      target.estimate));
}

void TargetPanel::editChosen(const QString& step,
                             const std::function<void(Project&, std::size_t)>& change) {
  const int row = chosenTarget();
  if (row < 0) {
    return;
  }
  const auto index = static_cast<std::size_t>(row);
  if (!document_.edit(
          step, [&](Project& project) { change(project, index); },
          step.toStdString() + std::to_string(index))) {
    showChosen(); // refused: show what holds
  }
}

void TargetPanel::rename() {
  editChosen(tr("Rename target"), [this](Project& project, std::size_t index) {
    project.targets[index].name = name_->text().trimmed().toStdString();
  });
}

void TargetPanel::resizeTarget(double millimeters) {
  editChosen(tr("Change radius"), [millimeters](Project& project, std::size_t index) {
    project.targets[index].radius = fromMillimeters(millimeters);
  });
}

void TargetPanel::reshapeTarget(int shape) {
  editChosen(tr("Change shape"), [shape](Project& project, std::size_t index) {
    project.targets[index].shape = static_cast<TargetShape>(shape);
  });
}

void TargetPanel::toggleTargetShown(int row) {
  const auto& targets = document_.project().targets;
  const auto index = static_cast<std::size_t>(row);
  if (row < 0 || index >= targets.size()) {
    return;
  }
  (void)document_.edit(targets[index].isShown ? tr("Hide target") : tr("Show target"),
                       [index](Project& project) {
                         Target& target = project.targets[index];
                         target.isShown = !target.isShown;
                       });
}

void TargetPanel::removeChosenTarget() {
  editChosen(tr("Remove target"),
             [](Project& project, std::size_t index) { removeTarget(project, index); });
  document_.endStepMerging();
}

} // namespace dewpoint::ui

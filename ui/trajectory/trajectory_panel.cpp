// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trajectory/trajectory_panel.h"

#include "core/session/snapshot/snapshot.h"
#include "core/trajectory/motion_csv.h"
#include "ui/actions/action_registry.h"
#include "ui/document/method_presentation.h"
#include "ui/plots/plot_stack.h"
#include "ui/text/retranslation.h"
#include "ui/trajectory/box_panel.h"
#include "ui/trajectory/frame_row_delegate.h"
#include "ui/trajectory/gap_list.h"
#include "ui/trajectory/trajectory_model.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QStackedLayout>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kLeastRefreshMs = 150;
constexpr double kShare = 0.05;           ///< of the time, for fetching and showing
constexpr std::size_t kMostPlaces = 4000; ///< of a range in the room

} // namespace

TrajectoryPanel::TrajectoryPanel(ActionRegistry& actions, Selection& selection, QWidget* parent)
    : QWidget(parent), actions_(actions), selection_(selection), model_(new TrajectoryModel(this)),
      table_(new QTableView(this)), gaps_(new GapList(this)), summary_(new QLabel(this)),
      plots_(new PlotStack(this)), boxes_(new BoxPanel(selection, this)),
      pages_(new QStackedLayout(this)) {
  setObjectName(QStringLiteral("trajectoryPanel"));
  auto* split = new QSplitter(Qt::Horizontal, this);
  split->setObjectName(QStringLiteral("trajectorySplit"));
  split->setChildrenCollapsible(false);
  pages_->addWidget(split);
  pages_->addWidget(boxes_);
  auto* right = new QSplitter(Qt::Horizontal, split);
  right->setObjectName(QStringLiteral("motionSplit"));
  makeTable();
  makePlots();
  auto* gapSide = new QWidget(right);
  auto* column = new QVBoxLayout(gapSide);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  summary_->setObjectName(QStringLiteral("trajectorySummary"));
  summary_->setContentsMargins(8, 4, 8, 4);
  summary_->setWordWrap(true);
  column->addWidget(summary_);
  column->addWidget(gaps_, 1);
  right->addWidget(plots_);
  right->addWidget(gapSide);
  right->setStretchFactor(0, 3);
  right->setStretchFactor(1, 2);
  split->addWidget(table_);
  split->addWidget(right);
  split->setStretchFactor(0, 1);
  split->setStretchFactor(1, 1);
  // Shares; the table does not ask for the width of its columns.
  split->setSizes({500, 500});
  right->setSizes({300, 200});
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &TrajectoryPanel::fetch);
  sinceRefresh_.start();
  connectViews();
}

TrajectoryPanel::~TrajectoryPanel() = default;

void TrajectoryPanel::makeTable() {
  table_->setObjectName(QStringLiteral("trajectoryTable"));
  table_->setModel(model_);
  head_ = new FrameRowDelegate(table_, selection_, [this](qint64 frame) {
    return model_->rowsOf(SelectedRange{frame, frame});
  });
  onRetranslate(table_, [this] {
    table_->setAccessibleName(tr("Trajectory"));
    const QFontMetrics metrics = table_->fontMetrics();
    const QString widestState =
        std::max({TrajectoryModel::tr("○ not tracked"), TrajectoryModel::tr("◆ corrected"),
                  TrajectoryModel::tr("◇ ambiguous")},
                 [&](const QString& one, const QString& other) {
                   return metrics.horizontalAdvance(one) < metrics.horizontalAdvance(other);
                 });
    for (int column = 0; column < TrajectoryModel::ColumnCount; ++column) {
      const QString title = model_->headerData(column, Qt::Horizontal).toString();
      const QString widest = column == TrajectoryModel::Target ? QStringLiteral("pink ball 1")
                             : column == TrajectoryModel::Held ? widestState
                                                               : QStringLiteral("0000.00");
      table_->setColumnWidth(column, 16 + std::max(metrics.horizontalAdvance(title),
                                                   metrics.horizontalAdvance(widest)));
    }
  });
}

void TrajectoryPanel::makePlots() {
  plots_->setObjectName(QStringLiteral("motionPlots"));
  plots_->setAxis(PlotAxis::Time);
  plots_->setShownPlots({QStringLiteral("speed"), QStringLiteral("height")});
  onRetranslate(plots_, [this] {
    plots_->focusProxy()->setAccessibleName(tr("Speed and height over time"));
    plots_->setEmptyText(tr("Speed and height appear during tracking."));
    plots_->setPlots(
        {{QStringLiteral("speed"),
          tr("Speed"),
          PlotQuantity::Speed,
          {{tr("speed"), QStringLiteral("speed_m_s"), MotionSeries::kSpeedColumn, 0}}},
         {QStringLiteral("height"),
          tr("Height"),
          PlotQuantity::Position,
          {{QStringLiteral("z"), QStringLiteral("z_m"), MotionSeries::kHeightColumn, 2}}}});
    updateSummary();
  });
  plots_->setSeries(&motion_.series());
}

void TrajectoryPanel::connectViews() {
  plots_->connectSelection(selection_);
  connect(gaps_, &GapList::gapChosen, this, [this](qint64 first, qint64 last) {
    selection_.selectRange(SelectedRange{first, last});
  });
  connect(&selection_, &Selection::selectedRangeChanged, this, &TrajectoryPanel::showSelectedRange);
  connect(&selection_, &Selection::currentFrameChanged, this, &TrajectoryPanel::showCurrentFrame);
  connect(&selection_, &Selection::targetSelected, this, [this](int target) {
    const auto chosen = static_cast<std::size_t>(std::max(0, target));
    setTarget(chosen < names_.size() ? names_[chosen] : std::string());
  });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &TrajectoryPanel::chooseRows);
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    selection_.requestFrame(
        model_->log().rows()[static_cast<std::size_t>(index.row())].sample.frame);
  });
  connect(actions_.action("actionTrajectoryCopy"), &QAction::triggered, this,
          &TrajectoryPanel::copyCsv);
  const auto menuAt = [this](const QPoint& place) { showMenu(place, -1); };
  connect(table_, &QWidget::customContextMenuRequested, this, [this](const QPoint& place) {
    showMenu(table_->viewport()->mapToGlobal(place), table_->rowAt(place.y()));
  });
  connect(plots_, &PlotStack::contextMenuRequested, this, menuAt);
  connect(boxes_, &BoxPanel::contextMenuRequested, this, menuAt);
}

void TrajectoryPanel::showMenu(const QPoint& place, int row) {
  QMenu menu(this);
  menu.addAction(actions_.action("actionTrajectoryCopy"));
  menu.addAction(actions_.action("actionExportTrajectory"));
  if (row >= 0 && model_->log().rows()[static_cast<std::size_t>(row)].sample.isCorrected) {
    const TrajectorySample& sample = model_->log().rows()[static_cast<std::size_t>(row)].sample;
    const auto target = std::ranges::find(names_, sample.target) - names_.begin();
    connect(menu.addAction(tr("Remove correction")), &QAction::triggered, this,
            [this, frame = qint64(sample.frame), target] {
              Q_EMIT correctionRemovalRequested(frame, static_cast<int>(target));
            });
  }
  menu.exec(place);
}

void TrajectoryPanel::setSource(Source source) {
  source_ = std::move(source);
  generation_ = 0;
  position_ = 0;
  model_->clear();
  motion_.clear();
  gaps_->setGaps({});
  plots_->refresh();
  highlight();
  updateSummary();
  refresh();
}

void TrajectoryPanel::refresh() {
  boxes_->refresh();
  if (timer_.isActive() || !isVisible()) {
    return;
  }
  const double pause = std::max<double>(kLeastRefreshMs, lastRefreshMs_ / kShare);
  timer_.start(
      static_cast<int>(std::max(0.0, pause - static_cast<double>(sinceRefresh_.elapsed()))));
}

void TrajectoryPanel::fetch() {
  if (!source_) {
    return;
  }
  QElapsedTimer took;
  took.start();
  const LogUpdate<TrajectorySample> piece = source_(generation_, position_);
  const bool choosing = std::exchange(choosing_, true); // rows that go take their selection along
  if (piece.restarted && model_->rowCount() > 0 && piece.records.empty()) {
    model_->clear();
    updatePlots(0);
  }
  if (!piece.records.empty()) {
    if (motion_.target().empty()) {
      motion_.setTarget(piece.records.front().target, {});
    }
    updatePlots(model_->replaceFrom(piece.first, piece.records));
  }
  choosing_ = choosing;
  gaps_->setGaps(model_->log().gaps());
  showCurrentFrame();
  head_->refresh();
  updateSummary();
  lastRefreshMs_ = static_cast<double>(took.nsecsElapsed()) * 1e-6;
  sinceRefresh_.restart();
}

void TrajectoryPanel::updatePlots(std::size_t firstChangedRow) {
  motion_.update(model_->log().rows(), firstChangedRow);
  plots_->refresh();
}

void TrajectoryPanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  boxes_->setSnapshot(snapshot);
  if (!snapshot) {
    return; // what follows the run empties the table
  }
  pages_->setCurrentIndex(presentationOf(*snapshot).resultsAreBoxes ? 1 : 0);
  names_.clear();
  for (const TargetSnapshot& target : snapshot->targets) {
    names_.push_back(target.target.name);
  }
}

void TrajectoryPanel::setTarget(const std::string& name) {
  if (name != motion_.target() && !name.empty()) {
    motion_.setTarget(name, model_->log().rows());
    plots_->refresh();
    highlight();
  }
}

void TrajectoryPanel::copyCsv() {
  if (pages_->currentWidget() == boxes_) {
    QGuiApplication::clipboard()->setText(QString::fromUtf8(boxes_->csv()));
    Q_EMIT noticeRequested(tr("The boxes are on the clipboard as CSV."));
    return;
  }
  fetch();
  const auto& rows = model_->log().rows();
  auto [first, last] = std::pair(0, static_cast<int>(rows.size()));
  if (const auto selected = table_->selectionModel()->selection(); !selected.isEmpty()) {
    first = selected.front().top();
    last = selected.front().bottom() + 1;
  }
  std::vector<MotionLog::Row> chosen(rows.begin() + first, rows.begin() + last);
  csv_.start([this, chosen = std::move(chosen)](const BackgroundJob::Progress&) {
    const QString text = QString::fromStdString(motionCsv(chosen));
    const int count = static_cast<int>(chosen.size());
    return [this, text, count] {
      QGuiApplication::clipboard()->setText(text);
      Q_EMIT noticeRequested(tr("%n rows are on the clipboard as CSV.", nullptr, count));
    };
  });
}

void TrajectoryPanel::updateSummary() {
  const int rows = model_->rowCount();
  summary_->setText(rows == 0 ? tr("The trajectory appears here as soon as the target is tracked.")
                    : gaps_->rowCount() == 0 ? tr("%n samples, no gaps", nullptr, rows)
                                             : tr("%n samples", nullptr, rows));
}

void TrajectoryPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void TrajectoryPanel::chooseRows() {
  if (choosing_) {
    return;
  }
  const auto selected = table_->selectionModel()->selection();
  choosing_ = true; // the rows stay as they were chosen
  if (selected.isEmpty()) {
    selection_.selectRange(std::nullopt);
  } else {
    const auto& rows = model_->log().rows();
    const auto& top = rows[static_cast<std::size_t>(selected.front().top())].sample;
    const auto& bottom = rows[static_cast<std::size_t>(selected.front().bottom())].sample;
    const auto target = std::ranges::find(names_, top.target);
    if (target != names_.end()) {
      selection_.selectTarget(static_cast<int>(target - names_.begin()));
    }
    selection_.selectRange(SelectedRange{top.frame, bottom.frame});
  }
  choosing_ = false;
}

void TrajectoryPanel::showSelectedRange() {
  const bool byRows = choosing_;
  fetch(); // the range may have samples that were not fetched while it was hidden
  gaps_->setSelectedRange(selection_.selectedRange());
  if (!byRows) {
    selectRange();
  }
  choosing_ = byRows;
  highlight();
}

void TrajectoryPanel::selectRange() {
  choosing_ = true;
  const auto [first, last] =
      selection_.selectedRange() ? model_->rowsOf(*selection_.selectedRange()) : std::pair(0, 0);
  if (first < last) {
    const QItemSelection rows(model_->index(first, 0),
                              model_->index(last - 1, TrajectoryModel::ColumnCount - 1));
    table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    table_->selectionModel()->setCurrentIndex(model_->index(first, 0),
                                              QItemSelectionModel::NoUpdate);
    table_->scrollTo(model_->index(first, 0));
  } else {
    table_->clearSelection();
  }
  choosing_ = false;
}

void TrajectoryPanel::highlight() {
  const auto [first, last] =
      selection_.selectedRange() ? model_->rowsOf(*selection_.selectedRange()) : std::pair(0, 0);
  Q_EMIT highlightChanged(pathSegments(model_->log().rows(), static_cast<std::size_t>(first),
                                       static_cast<std::size_t>(last), motion_.target(),
                                       kMostPlaces));
}

void TrajectoryPanel::showCurrentFrame() {
  // At the newest frame there is no line: the curves end there.
  const auto& rows = model_->log().rows();
  const bool past = !rows.empty() && selection_.currentFrame() < rows.back().sample.frame;
  plots_->setCurrentFrame(past ? std::optional<std::int64_t>(selection_.currentFrame())
                               : std::nullopt);
}

void TrajectoryPanel::choosePosition(int target, const Eigen::Vector3d& position, bool extend) {
  fetch();
  if (target < 0 || static_cast<std::size_t>(target) >= names_.size()) {
    return;
  }
  const std::string& name = names_[static_cast<std::size_t>(target)];
  const auto& rows = model_->log().rows();
  const auto found = std::find_if(rows.rbegin(), rows.rend(), [&](const MotionLog::Row& row) {
    return row.sample.target == name && row.sample.position == position;
  });
  if (found == rows.rend()) {
    return;
  }
  selection_.selectTarget(target);
  if (extend && selection_.currentFrame() >= 0) {
    selection_.selectRange(SelectedRange{selection_.currentFrame(), found->sample.frame});
  } else {
    selection_.requestFrame(found->sample.frame);
  }
}

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_panel.h"

#include "core/session/snapshot/snapshot.h"
#include "ui/actions/action_registry.h"
#include "ui/document/method_presentation.h"
#include "ui/plots/frame_convergence.h"
#include "ui/plots/plot_export.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/run_plots.h"
#include "ui/preferences/preferences.h"
#include "ui/text/camera_names.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/file_choice.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include <array>

namespace dewpoint::ui {

namespace {

/// Actions that show a plot, and its id.
struct Choice {
  ActionId action;
  const char* plot;
};
constexpr std::array<Choice, 7> kChoices{{{"actionPlotPosition", "position"},
                                          {"actionPlotSpread", "spread"},
                                          {"actionPlotSampleSize", "sampleSize"},
                                          {"actionPlotLikelihood", "likelihood"},
                                          {"actionPlotExistence", "existence"},
                                          {"actionPlotError", "error"},
                                          {"actionPlotDuration", "duration"}}};

QStringList chosenPlots() {
  return Preferences().shownPlots().value_or(QStringList{
      QStringLiteral("position"), QStringLiteral("spread"), QStringLiteral("sampleSize"),
      QStringLiteral("likelihood"), QStringLiteral("error")});
}

} // namespace

PlotPanel::PlotPanel(ActionRegistry& actions, Selection& selection, QWidget* parent)
    : QWidget(parent), actions_(actions), selection_(selection), stack_(new PlotStack(this)),
      convergence_(new FrameConvergence(this)) {
  setObjectName(QStringLiteral("plotPanel"));
  stack_->setObjectName(QStringLiteral("plotStack"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(1);
  layout->addWidget(stack_, 1);
  layout->addWidget(convergence_);
  onRetranslate(this, [this] {
    updateCameras();
    stack_->setEmptyText(tr("Plots appear during tracking."));
    stack_->setAccessibleName(tr("Plots of the run"));
    stack_->focusProxy()->setAccessibleName(tr("Plots of the run"));
  });
  connectActions();
  stack_->setSeries(&seriesOf(0));
  stack_->connectSelection(selection_);
  connect(&selection_, &Selection::currentFrameChanged, this, &PlotPanel::showCurrentFrame);
  connect(&selection_, &Selection::targetSelected, this,
          [this](int target) { setTarget(std::max(0, target)); });
}

PlotPanel::~PlotPanel() = default;

void PlotPanel::connectActions() {
  const QStringList chosen = chosenPlots();
  for (const auto& [action, plot] : kChoices) {
    QAction* choice = actions_.action(action);
    choice->setChecked(chosen.contains(QLatin1String(plot)));
    connect(choice, &QAction::toggled, this, &PlotPanel::saveShownPlots);
  }
  QAction* overTime = actions_.action("actionPlotOverTime");
  const auto show = [this](bool time) {
    stack_->setAxis(time ? PlotAxis::Time : PlotAxis::Iterations);
  };
  overTime->setChecked(Preferences().showsPlotsOverTime());
  show(overTime->isChecked());
  connect(overTime, &QAction::toggled, this, [show](bool time) {
    show(time);
    Preferences().setShowsPlotsOverTime(time); // only what the user chose is stored
  });
  connect(actions_.action("actionPlotAll"), &QAction::triggered, stack_, &PlotStack::showWholeRun);
  connect(actions_.action("actionPlotCopy"), &QAction::triggered, this, &PlotPanel::copyCsv);
  connect(actions_.action("actionPlotSave"), &QAction::triggered, this,
          &PlotPanel::chooseImageFile);
  connect(stack_, &PlotStack::contextMenuRequested, this, [this](const QPoint& place) {
    QMenu menu(this);
    fillMenu(&menu);
    menu.exec(place);
  });
  stack_->setShownPlots(chosen);
}

void PlotPanel::fillMenu(QMenu* menu) const {
  for (const auto& choice : kChoices) {
    menu->addAction(actions_.action(choice.action));
  }
  menu->addSeparator();
  for (const ActionId id : std::initializer_list<ActionId>{"actionPlotOverTime", "actionPlotAll",
                                                           "actionPlotCopy", "actionPlotSave"}) {
    menu->addAction(actions_.action(id));
  }
}

void PlotPanel::saveShownPlots() {
  QStringList chosen;
  for (const auto& [action, plot] : kChoices) {
    if (actions_.action(action)->isChecked()) {
      chosen << QLatin1String(plot);
    }
  }
  Preferences().setShownPlots(chosen);
  stack_->setShownPlots(chosen);
}

QWidget* PlotPanel::makeTitleTools(QWidget* parent) {
  auto* tools = new QWidget(parent);
  tools->setObjectName(QStringLiteral("plotTools"));
  auto* row = new QHBoxLayout(tools);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  targetName_ = new QLabel(tools);
  targetName_->setObjectName(QStringLiteral("plotTarget"));
  row->addWidget(targetName_);
  onRetranslate(targetName_, [this] {
    targetName_->setToolTip(tr("The target whose values are plotted: the target selected in the "
                               "panel Target, or the first target if none is selected."));
  });
  auto* place = new QLabel(tools);
  place->setObjectName(QStringLiteral("plotPlace"));
  place->setForegroundRole(QPalette::PlaceholderText);
  row->addWidget(place);
  connect(stack_, &PlotStack::cursorMoved, place, [this, place] {
    place->setText(stack_->shownFrameText());
    stack_->focusProxy()->setAccessibleDescription(stack_->valuesText());
  });
  onRetranslate(place, [place] {
    place->setToolTip(tr("The frame that all views show. The numbers beside the plots are the "
                         "values in this frame.\nIn the plots, the wheel scrolls, Ctrl+wheel zooms "
                         "in time at the pointer, and Shift+wheel moves along the time axis."));
  });
  const auto button = [&](const char* name) {
    auto* made = new QToolButton(tools);
    made->setObjectName(QLatin1String(name));
    made->setAutoRaise(true);
    row->addWidget(made);
    return made;
  };
  QToolButton* time = button("plotOverTime");
  time->setDefaultAction(actions_.action("actionPlotOverTime"));
  time->setFocusPolicy(Qt::TabFocus);
  QToolButton* all = button("plotAll");
  all->setDefaultAction(actions_.action("actionPlotAll"));
  all->setFocusPolicy(Qt::TabFocus);
  QToolButton* choice = button("plotChoice");
  choice->setPopupMode(QToolButton::InstantPopup);
  choice->setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(choice);
  menu->setToolTipsVisible(true);
  fillMenu(menu);
  choice->setMenu(menu);
  onRetranslate(choice, [choice] {
    choice->setText(tr("Plots"));
    choice->setToolTip(tr("Choose which plots to show; copy or save plots"));
    choice->setAccessibleName(tr("Choose which plots to show"));
  });
  return tools;
}

PlotSeries& PlotPanel::seriesOf(int target) {
  while (series_.size() <= static_cast<std::size_t>(target)) {
    series_.push_back(std::make_unique<PlotSeries>());
    series_.back()->reset(columnCountOfRunPlots(static_cast<int>(cameras_.size())));
  }
  return *series_[static_cast<std::size_t>(target)];
}

void PlotPanel::append(const std::vector<IterationRecord>& records) {
  for (const IterationRecord& record : records) {
    PlotSeries& series = seriesOf(record.target);
    // A method may have fewer iterations behind it than before.
    if (series.size() > 0 && record.iteration <= series.row(series.size() - 1).iteration) {
      series.removeFrom(record.frame);
    }
    appendIteration(series, record);
  }
  if (!records.empty()) {
    showCurrentFrame();
    stack_->refresh();
  }
}

void PlotPanel::clear() {
  const std::size_t columns = columnCountOfRunPlots(static_cast<int>(cameras_.size()));
  for (const auto& series : series_) {
    series->reset(columns);
  }
  stack_->setCurrentFrame(std::nullopt);
  stack_->setHoveredFrame(std::nullopt);
  convergence_->showFrame(seriesOf(target_), std::nullopt);
  stack_->refresh();
}

void PlotPanel::updateTargetName() {
  if (targetName_ != nullptr) {
    targetName_->setText(targets_.value(target_));
  }
}

void PlotPanel::updateCameras() {
  stack_->setPlots(showsBoxes_ ? plotsOfBoxRun() : plotsOfRun(cameras_));
}

void PlotPanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  targets_.clear();
  if (!snapshot) {
    updateTargetName();
    clear();
    return;
  }
  for (const TargetSnapshot& target : snapshot->targets) {
    targets_.append(QString::fromStdString(target.target.name));
  }
  updateTargetName();
  const QStringList cameras = snapshot->rig ? cameraNames(*snapshot->rig) : QStringList();
  const bool resultsAreBoxes = presentationOf(*snapshot).resultsAreBoxes;
  if (cameras != cameras_ || !camerasKnown_ || resultsAreBoxes != showsBoxes_) {
    camerasKnown_ = true;
    showsBoxes_ = resultsAreBoxes;
    cameras_ = cameras;
    for (const auto& series : series_) {
      series->reset(columnCountOfRunPlots(static_cast<int>(cameras_.size())));
    }
    convergence_->setTargetIsBox(resultsAreBoxes);
    updateCameras();
  }
}

void PlotPanel::showCurrentFrame() {
  // At the newest frame there is no line: the curves end there.
  const PlotSeries& series = seriesOf(target_);
  const std::int64_t frame = selection_.currentFrame();
  const bool past = series.size() > 0 && frame < series.row(series.size() - 1).frame;
  stack_->setCurrentFrame(past ? std::optional(frame) : std::nullopt);
  convergence_->showFrame(series, past ? std::optional(frame) : std::nullopt);
}

void PlotPanel::setTarget(int target) {
  if (target >= 0 && target != target_) {
    target_ = target;
    stack_->setSeries(&seriesOf(target));
    updateTargetName();
    showCurrentFrame();
  }
}

int PlotPanel::shownIterationCount() const {
  const auto target = static_cast<std::size_t>(target_);
  return target < series_.size() ? static_cast<int>(series_[target]->size()) : 0;
}

void PlotPanel::copyCsv() {
  QGuiApplication::clipboard()->setText(QString::fromStdString(stack_->plotExport().csv()));
  Q_EMIT noticeRequested(tr("The plots are on the clipboard as CSV."));
}

void PlotPanel::chooseImageFile() {
  const QString file = askForFileToSave(this, tr("Save the plots"), QStringLiteral("plots.svg"),
                                        tr("Drawings (*.svg);;Pictures (*.png)"));
  if (!file.isEmpty()) {
    savePicture(file);
  }
}

void PlotPanel::savePicture(const QString& file) {
  const bool asSvg = file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
  files_.add([this, file, picture = stack_->plotExport().image(asSvg)]() -> std::function<void()> {
    const bool saved = picture.save(file);
    return [this, file, saved] {
      if (saved) {
        Q_EMIT noticeRequested(tr("Saved %1.").arg(file));
      } else {
        Q_EMIT failed(tr("%1 could not be written.").arg(file));
      }
    };
  });
}

} // namespace dewpoint::ui

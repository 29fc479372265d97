// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_declaration.h"
#include "ui/plots/plot_navigation.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QCustomPlot;

namespace dewpoint::ui {

class PlotCursor;
class PlotExport;
class PlotPointer;
class PlotRow;
class PlotScroll;

/// Plots one above the other that share an axis of iterations or time, a cursor and a range.
/// Without enough room they scroll above the axis numbers; without data a sentence is shown. New
/// data are drawn at most a few times per second, however often `refresh()` is called. The whole
/// run is shown unless a part of the axis is selected.
class PlotStack : public QWidget {
  Q_OBJECT
public:
  explicit PlotStack(QWidget* parent = nullptr);
  ~PlotStack() override;

  /// Sets all plots; data of earlier plots are dropped.
  void setPlots(std::vector<PlotDeclaration> plots);
  /// Sets which plots are shown, by id. Plots without data take no space.
  void setShown(const QStringList& ids);
  /// Sets the data to draw. The series must outlive the stack or be replaced.
  void setSeries(const PlotSeries* series);
  /// Schedules a redraw, because the series has changed.
  void refresh();
  /// Sets the sentence shown while there are no data.
  void setEmptyText(const QString& sentence);
  /// Sets whether only curves and axes are shown, for a stack that is explained by its
  /// surroundings.
  void setBare(bool bare);
  /// A run of fewer iterations than that grows into the axis.
  void setLeastIterations(int least) { navigation_->setLeastIterations(least); }
  void setAxis(PlotAxis axis);
  PlotAxis axis() const { return navigation_->axis(); }

  /// Shows the range of the selection, and selects what the user points at.
  void link(Selection& selection);
  /// Shows the frame under the pointer in both stacks.
  void shareCursor(PlotStack& other);
  /// The frame all views show; nothing: the newest.
  void setCurrentFrame(std::optional<std::int64_t> frame) { navigation_->setCurrentFrame(frame); }
  /// The frame the pointer is on, here or in another view; nothing: nowhere.
  void setHovered(std::optional<std::int64_t> frame) { navigation_->setHovered(frame); }
  std::optional<SelectedRange> selectedRange() const { return navigation_->selectedRange(); }
  /// The part of the axis that is shown.
  std::pair<double, double> shownRange() const { return navigation_->shownRange(); }
  /// The whole run again.
  void showAll() { navigation_->showAll(); }
  /// This part of the axis.
  void showPart(double lower, double upper) { navigation_->showPart(lower, upper); }
  bool showsAll() const { return navigation_->showsAll(); }

  /// What is shown now, for other programs.
  PlotExport exported();
  /// All values at the cursor, with names and units.
  QString valuesText() const;
  /// Returns "frame 132, iteration 660, 4.40 s"; empty before the first frame.
  QString cursorText() const;
  /// Duration of the last redraw, milliseconds.
  double lastDrawingMs() const { return lastDrawingMs_; }
  /// Whether everything given last is drawn.
  bool isDrawn() const { return !timer_.isActive(); }
  /// Number of points in the drawn curves.
  int drawnPoints() const;
  QStringList visiblePlots() const;
  /// Visible plots that are fully in view without scrolling.
  QStringList plotsInSight() const;
  /// Whether any curve shows dots.
  bool hasDots() const;

  QSize sizeHint() const override { return {700, 240}; }

Q_SIGNALS:
  /// The pointer (or the cursor moved by arrow keys) is on this frame; negative: on none.
  void hovered(qint64 frame);
  void cursorMoved();
  void contextMenuWanted(const QPoint& global);

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void rebuild();
  void placeRows(const std::vector<const PlotDeclaration*>& wanted);
  void draw();
  void drawCursor();
  void applyPalette();
  std::vector<const PlotDeclaration*> wantedPlots() const;
  const PlotSeries* series() const { return navigation_->series(); }

  QCustomPlot* plot_;
  PlotScroll* scroll_;
  PlotCursor* cursor_;
  PlotNavigation* navigation_;
  PlotPointer* pointer_;
  bool bare_ = false;
  std::vector<PlotDeclaration> plots_;
  QStringList shown_;
  std::vector<std::unique_ptr<PlotRow>> rows_;
  QTimer timer_;
  QElapsedTimer sinceDrawing_;
  double lastDrawingMs_ = 0.0;
};

} // namespace dewpoint::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_navigation.h"

namespace dewpoint::ui {

void PlotNavigation::showWholeRun() {
  range_.showWholeRun();
  Q_EMIT shownRangeChanged();
}

void PlotNavigation::showRange(double lower, double upper) {
  range_.showRange(series_, lower, upper);
  Q_EMIT shownRangeChanged();
}

void PlotNavigation::zoom(double factor, std::optional<double> about) {
  const auto [lower, upper] = shownRange();
  const auto row = cursorRow();
  const double middle = about                                ? *about
                        : (hovered_ || currentFrame_) && row ? series_->axisPosition(*row, axis())
                                                             : (lower + upper) / 2.0;
  showRange(middle - (middle - lower) / factor, middle + (upper - middle) / factor);
}

void PlotNavigation::pan(double share) {
  const auto [lower, upper] = shownRange();
  const double moved = (upper - lower) * share;
  if (!range_.showsWholeRun()) {
    showRange(lower + moved, upper + moved);
  }
}

void PlotNavigation::setCurrentFrame(std::optional<std::int64_t> frame) {
  if (frame != currentFrame_) {
    currentFrame_ = frame;
    Q_EMIT cursorChanged();
  }
}

void PlotNavigation::setHoveredFrame(std::optional<std::int64_t> frame) {
  if (frame != hovered_) {
    hovered_ = frame;
    Q_EMIT cursorChanged();
  }
}

void PlotNavigation::setSelectedRange(std::optional<SelectedRange> selectedRange) {
  if (selectedRange != selectedRange_) {
    selectedRange_ = selectedRange;
    Q_EMIT cursorChanged();
  }
}

void PlotNavigation::setDraggedRange(std::optional<std::pair<double, double>> part) {
  if (part != dragged_) {
    dragged_ = part;
    Q_EMIT cursorChanged();
  }
}

std::optional<double> PlotNavigation::positionOf(const std::optional<std::int64_t>& frame) const {
  const auto row = series_ != nullptr && frame ? series_->rowAtFrame(*frame) : std::nullopt;
  return row ? std::optional(series_->axisPosition(*row, axis())) : std::nullopt;
}

std::optional<std::int64_t> PlotNavigation::frameAt(double position) const {
  const auto row = series_ != nullptr ? series_->nearestRow(axis(), position) : std::nullopt;
  return row ? std::optional(series_->row(*row).frame) : std::nullopt;
}

std::optional<std::size_t> PlotNavigation::rowOf(const std::optional<std::int64_t>& frame) const {
  if (series_ == nullptr || series_->size() == 0) {
    return std::nullopt;
  }
  return frame ? series_->rowAtFrame(*frame) : series_->size() - 1;
}

std::optional<std::size_t> PlotNavigation::cursorRow() const {
  return rowOf(hovered_ ? hovered_ : currentFrame_);
}

std::optional<std::size_t> PlotNavigation::shownRow() const {
  return rowOf(currentFrame_);
}

} // namespace dewpoint::ui

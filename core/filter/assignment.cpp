// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/assignment.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace dewpoint::filter {
namespace {

/// A cost that counts forbidden pairs first: they stay selectable, so that every row finds a path,
/// but one of them outweighs any sum of allowed costs. Exact, unlike one very large number.
struct RankedCost {
  std::int64_t forbidden = 0;
  double value = 0.0;

  RankedCost operator+(const RankedCost& other) const {
    return {forbidden + other.forbidden, value + other.value};
  }
  RankedCost operator-(const RankedCost& other) const {
    return {forbidden - other.forbidden, value - other.value};
  }
  bool operator<(const RankedCost& other) const {
    return forbidden != other.forbidden ? forbidden < other.forbidden : value < other.value;
  }
};

constexpr RankedCost kFarthest{std::numeric_limits<std::int64_t>::max(),
                               std::numeric_limits<double>::infinity()};

/// Gives every row a column; there must be no more rows than columns.
class ShortestPathSolver {
public:
  explicit ShortestPathSolver(const Eigen::MatrixXd& cost)
      : cost_(cost), rowPrice_(static_cast<std::size_t>(cost.rows())), columns_(count(cost)) {}

  /// The row of each column, kUnassigned for the columns left over.
  std::vector<Eigen::Index> solve() {
    for (Eigen::Index row = 0; row < cost_.rows(); ++row)
      augment(row);
    std::vector<Eigen::Index> rows;
    for (const Column& column : columns_)
      rows.push_back(column.row);
    return rows;
  }

private:
  struct Column {
    Eigen::Index row = kUnassigned;
    RankedCost price;
    // The search from one new row:
    RankedCost distance;
    Eigen::Index cameFrom = kUnassigned; ///< the row before this column on the shortest path
    bool settled = false;
  };

  static std::size_t count(const Eigen::MatrixXd& cost) {
    return static_cast<std::size_t>(cost.cols());
  }

  RankedCost costOf(Eigen::Index row, std::size_t column) const {
    const double cost = cost_(row, static_cast<Eigen::Index>(column));
    return std::isfinite(cost) ? RankedCost{0, cost} : RankedCost{1, 0.0};
  }

  RankedCost& priceOf(Eigen::Index row) { return rowPrice_[static_cast<std::size_t>(row)]; }

  void relax(Eigen::Index row, const RankedCost& soFar) {
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      Column& column = columns_[j];
      if (column.settled)
        continue;
      const RankedCost distance = soFar + costOf(row, j) - priceOf(row) - column.price;
      if (distance < column.distance) {
        column.distance = distance;
        column.cameFrom = row;
      }
    }
  }

  std::size_t settleNearest() {
    std::size_t nearest = columns_.size();
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (columns_[j].settled)
        continue;
      if (nearest == columns_.size() || columns_[j].distance < columns_[nearest].distance)
        nearest = j;
    }
    columns_[nearest].settled = true;
    return nearest;
  }

  /// Dijkstra from a new row to the nearest free column, which it returns.
  std::size_t findFreeColumn(Eigen::Index newRow) {
    for (Column& column : columns_) {
      column.distance = kFarthest;
      column.settled = false;
    }
    relax(newRow, RankedCost{});
    for (;;) {
      const std::size_t nearest = settleNearest();
      if (columns_[nearest].row == kUnassigned)
        return nearest;
      relax(columns_[nearest].row, columns_[nearest].distance);
    }
  }

  void augment(Eigen::Index newRow) {
    std::size_t column = findFreeColumn(newRow);
    const RankedCost length = columns_[column].distance;
    // New prices keep all reduced costs non-negative, and zero along the path.
    priceOf(newRow) = priceOf(newRow) + length;
    for (Column& passed : columns_) {
      if (!passed.settled || passed.row == kUnassigned)
        continue;
      const RankedCost change = length - passed.distance;
      priceOf(passed.row) = priceOf(passed.row) + change;
      passed.price = passed.price - change;
    }
    for (Eigen::Index row = kUnassigned; row != newRow;) {
      row = columns_[column].cameFrom;
      const Eigen::Index released = columnOf(row, newRow);
      columns_[column].row = row;
      column = static_cast<std::size_t>(released);
    }
  }

  /// The column that `row` holds before the path is turned over; the new row holds none.
  Eigen::Index columnOf(Eigen::Index row, Eigen::Index newRow) const {
    if (row == newRow)
      return kUnassigned;
    std::size_t held = 0;
    while (columns_[held].row != row)
      ++held;
    return static_cast<Eigen::Index>(held);
  }

  const Eigen::MatrixXd& cost_;
  std::vector<RankedCost> rowPrice_;
  std::vector<Column> columns_;
};

} // namespace

Assignment assignMinimumCost(const Eigen::MatrixXd& cost) {
  Assignment result;
  result.columnOfRow.assign(static_cast<std::size_t>(cost.rows()), kUnassigned);
  const bool tall = cost.rows() > cost.cols();
  const Eigen::MatrixXd wide = tall ? Eigen::MatrixXd(cost.transpose()) : cost;
  const std::vector<Eigen::Index> partners = ShortestPathSolver(wide).solve();
  for (std::size_t own = 0; own < partners.size(); ++own) {
    const auto here = static_cast<Eigen::Index>(own);
    const Eigen::Index row = tall ? here : partners[own];
    const Eigen::Index column = tall ? partners[own] : here;
    if (row == kUnassigned || column == kUnassigned || !std::isfinite(cost(row, column)))
      continue;
    result.columnOfRow[static_cast<std::size_t>(row)] = column;
    result.cost += cost(row, column);
    ++result.pairCount;
  }
  return result;
}

} // namespace dewpoint::filter

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/level_curves.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

namespace dewpoint::geometry {
namespace {

/// An edge of the grid: its first point's column and row, and whether it runs along the rows.
struct Edge {
  Eigen::Index column;
  Eigen::Index row;
  bool upwards;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 of a comparison for a pointer.
  auto operator<=>(const Edge&) const = default;
};

using Segments = std::multimap<Edge, Edge>; // both directions

Eigen::Vector2d crossing(const GroundGrid& grid, const Edge& edge, double level) {
  const double from = grid.values(edge.column, edge.row);
  const double to = edge.upwards ? grid.values(edge.column, edge.row + 1)
                                 : grid.values(edge.column + 1, edge.row);
  const double part = (level - from) / (to - from);
  Eigen::Vector2d position(static_cast<double>(edge.column), static_cast<double>(edge.row));
  position[edge.upwards ? 1 : 0] += part;
  return grid.origin + grid.step * position;
}

/// The pieces of the curve within one cell of the grid.
void addCell(const GroundGrid& grid, double level, Eigen::Index i, Eigen::Index j,
             Segments& segments) {
  const std::array<double, 4> corner{grid.values(i, j), grid.values(i + 1, j),
                                     grid.values(i + 1, j + 1), grid.values(i, j + 1)};
  const std::array<Edge, 4> edge{Edge{i, j, false}, Edge{i + 1, j, true}, Edge{i, j + 1, false},
                                 Edge{i, j, true}};
  std::vector<std::size_t> cut;
  for (std::size_t k = 0; k < 4; ++k) {
    if ((corner[k] >= level) != (corner[(k + 1) % 4] >= level)) {
      cut.push_back(k);
    }
  }
  const auto connect = [&](std::size_t a, std::size_t b) {
    segments.emplace(edge[a], edge[b]);
    segments.emplace(edge[b], edge[a]);
  };
  if (cut.size() == 2) {
    connect(cut[0], cut[1]);
  } else if (cut.size() == 4) {
    const bool middle = corner[0] + corner[1] + corner[2] + corner[3] >= 4.0 * level;
    const bool around = middle == (corner[0] >= level); // corners 1 and 3 are cut off
    connect(0, around ? 1 : 3);
    connect(2, around ? 3 : 1);
  }
}

void dropSegment(Segments& segments, const Edge& from, const Edge& to) {
  const auto [begin, end] = segments.equal_range(from);
  segments.erase(std::find_if(begin, end, [&](const auto& one) { return one.second == to; }));
}

/// Follows the curve from `at` to where it ends, and removes it from the segments.
std::vector<Edge> follow(Segments& segments, Edge at) {
  std::vector<Edge> way{at};
  for (auto next = segments.find(at); next != segments.end(); next = segments.find(at)) {
    const Edge to = next->second;
    segments.erase(next);
    dropSegment(segments, to, at);
    way.push_back(to);
    at = to;
  }
  return way;
}

} // namespace

std::vector<LevelCurve> levelCurves(const GroundGrid& grid, double level) {
  Segments segments;
  for (Eigen::Index j = 0; j + 1 < grid.values.cols(); ++j) {
    for (Eigen::Index i = 0; i + 1 < grid.values.rows(); ++i) {
      addCell(grid, level, i, j, segments);
    }
  }
  std::vector<LevelCurve> curves;
  const auto take = [&](const Edge& from) {
    LevelCurve& curve = curves.emplace_back();
    for (const Edge& edge : follow(segments, from)) {
      curve.push_back(crossing(grid, edge, level));
    }
  };
  // First those that end at the border of the grid, from their ends; the rest is closed.
  std::vector<Edge> ends;
  for (auto at = segments.begin(); at != segments.end(); at = segments.upper_bound(at->first)) {
    if (segments.count(at->first) == 1) {
      ends.push_back(at->first);
    }
  }
  for (const Edge& end : ends) {
    if (segments.contains(end)) {
      take(end);
    }
  }
  while (!segments.empty()) {
    take(segments.begin()->first);
  }
  return curves;
}

double levelForProbability(const GroundGrid& grid, double probability) {
  std::vector<double> values(grid.values.data(), grid.values.data() + grid.values.size());
  std::ranges::sort(values, std::greater<>{});
  double total = 0.0;
  for (const double value : values) {
    total += value;
  }
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
    if (sum >= probability * total) {
      return value;
    }
  }
  return 0.0;
}

} // namespace dewpoint::geometry

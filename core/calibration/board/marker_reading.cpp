// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/marker_reading.h"

#include "core/calibration/board/board.h"
#include "core/calibration/board/marker_dictionary.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

namespace dewpoint::calibration {
namespace {

using MarkerOutline = std::array<cv::Point2f, 4>;
using MarkerReadings = std::map<MarkerReading, std::vector<ReadMarker>>;

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr int kCellPx = 6; // side of a cell in the straightened marker, pixels
/// Gray levels between the dark and the bright cells of a marker that can be read.
constexpr double kLeastSpread = 20.0;
constexpr double kInsetPx = 0.5; ///< outlines go through the centers of dark pixels
/// So many markers read in the same way are no accident.
constexpr std::size_t kClearlyRead = 4;
/// Centers of one marker found twice are nearer than that part of its side.
constexpr double kSamePlacePart = 0.3;

/// All markers of a code: each, in its four rotations, by its cells.
struct CodeTable {
  struct Entry {
    int id;
    int rotation; ///< quarter turns clockwise
  };
  int cells = 0; ///< cells in a row, without the border
  std::unordered_map<std::uint64_t, Entry> entries;
};

/// The cells (CV_8UC1, 0: black) as one number, row by row.
std::uint64_t numberOfCells(const cv::Mat& cells) {
  std::uint64_t number = 0;
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.cols; ++column) {
      number = 2 * number + (cells.at<unsigned char>(row, column) != 0 ? 1 : 0);
    }
  }
  return number;
}

CodeTable makeCodeTable(const std::string& name) {
  const MarkerDictionary dictionary(name);
  CodeTable table;
  table.cells = dictionary.cellsPerRow();
  for (int id = 0; id < dictionary.size(); ++id) {
    cv::Mat cells = dictionary.cellsOf(id);
    for (int rotation = 0; rotation < 4; ++rotation) {
      table.entries.try_emplace(numberOfCells(cells), CodeTable::Entry{id, rotation});
      cv::rotate(cells.clone(), cells, cv::ROTATE_90_CLOCKWISE);
    }
  }
  return table;
}

const std::vector<CodeTable>& codeTables() {
  static const std::vector<CodeTable> kTables = [] {
    std::vector<CodeTable> tables;
    for (const std::string& name : markerCodes()) {
      tables.push_back(makeCodeTable(name));
    }
    return tables;
  }();
  return kTables;
}

/// The quadrilaterals in an image that may be markers, clockwise.
std::vector<MarkerOutline> quadrilateralsIn(const cv::Mat& gray) {
  constexpr double kMinDistanceRate = 0.01; // a square close around a marker does not replace it
  auto [found, ids, others] =
      MarkerDictionary(markerCodes().front()).detect(gray, kMinDistanceRate);
  found.insert(found.end(), others.begin(), others.end());
  std::vector<MarkerOutline> outlines;
  for (const auto& corners : found) {
    MarkerOutline& outline = outlines.emplace_back();
    std::ranges::copy(corners, outline.begin());
  }
  return outlines;
}

/// The inner cells of what may be a marker (CV_8UC1, 0: black); nothing without a black border.
std::optional<cv::Mat> cellsInside(const cv::Mat& gray, const MarkerOutline& outline, int cells) {
  const int side = (cells + 2) * kCellPx;
  const auto end = static_cast<float>(side) - 0.5F;
  const MarkerOutline straight{{{-0.5F, -0.5F}, {end, -0.5F}, {end, end}, {-0.5F, end}}};
  cv::Mat patch;
  cv::warpPerspective(gray, patch, cv::getPerspectiveTransform(outline.data(), straight.data()),
                      {side, side}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::Scalar mean;
  cv::Scalar spread;
  cv::meanStdDev(patch, mean, spread);
  if (spread[0] < kLeastSpread / 2.0) {
    return std::nullopt;
  }
  cv::threshold(patch, patch, 0.0, 255.0, cv::THRESH_BINARY | cv::THRESH_OTSU);
  cv::Mat result(cells, cells, CV_8UC1);
  for (int row = 0; row < cells + 2; ++row) {
    for (int column = 0; column < cells + 2; ++column) {
      const cv::Rect inside(column * kCellPx + 1, row * kCellPx + 1, kCellPx - 2, kCellPx - 2);
      const bool white = cv::mean(patch(inside))[0] > 127.0;
      const bool border = row == 0 || column == 0 || row > cells || column > cells;
      if (border && white) {
        return std::nullopt;
      }
      if (!border) {
        result.at<unsigned char>(row - 1, column - 1) = white ? 1 : 0;
      }
    }
  }
  return result;
}

std::optional<ReadMarker> lookedUp(const CodeTable& table, const cv::Mat& cells,
                                   const MarkerOutline& outline) {
  const auto found = table.entries.find(numberOfCells(cells));
  if (found == table.entries.end()) {
    return std::nullopt;
  }
  ReadMarker marker{found->second.id, outline};
  std::rotate(marker.corners.begin(), marker.corners.begin() + found->second.rotation,
              marker.corners.end());
  return marker;
}

/// The outline in the mirrored image, clockwise there.
MarkerOutline mirroredOutline(const MarkerOutline& outline, int width) {
  MarkerOutline result{outline[1], outline[0], outline[3], outline[2]};
  for (cv::Point2f& corner : result) {
    corner.x = static_cast<float>(width - 1) - corner.x;
  }
  return result;
}

cv::Point2f centerOfOutline(const MarkerOutline& outline) {
  return (outline[0] + outline[1] + outline[2] + outline[3]) / 4.0F;
}

double perimeterOf(const MarkerOutline& outline) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += cv::norm(outline[(k + 1) % 4] - outline[k]);
  }
  return sum;
}

/// Where the outline is: its corners are found half a pixel inside the dark border.
MarkerOutline grownOutline(MarkerOutline outline) {
  const cv::Point2f center = centerOfOutline(outline);
  for (cv::Point2f& corner : outline) {
    const cv::Point2f outward = corner - center;
    corner +=
        outward * static_cast<float>(kInsetPx * std::sqrt(2.0) / std::max(1.0, cv::norm(outward)));
  }
  return outline;
}

/// Each marker once and in order; none that is seen at two places.
void keepEachOnce(std::vector<ReadMarker>& markers) {
  std::ranges::sort(markers, [](const ReadMarker& one, const ReadMarker& other) {
    return std::pair(one.id, -perimeterOf(one.corners)) <
           std::pair(other.id, -perimeterOf(other.corners));
  });
  std::vector<ReadMarker> kept;
  for (auto from = markers.begin(); from != markers.end();) {
    const auto until =
        std::find_if(from, markers.end(), [&](const ReadMarker& m) { return m.id != from->id; });
    const double reach = kSamePlacePart * perimeterOf(from->corners) / 4.0;
    if (std::all_of(from, until, [&](const ReadMarker& marker) {
          return cv::norm(centerOfOutline(marker.corners) - centerOfOutline(from->corners)) < reach;
        })) {
      kept.push_back(*from);
    }
    from = until;
  }
  markers = std::move(kept);
}

/// All readings of an image whose black and white were exchanged already if `inverted`.
MarkerReadings readMarkersAsPrinted(const cv::Mat& image, bool inverted) {
  MarkerReadings readings;
  for (const MarkerOutline& outline : quadrilateralsIn(image)) {
    for (std::size_t code = 0; code < codeTables().size(); ++code) {
      const CodeTable& table = codeTables()[code];
      const auto cells = cellsInside(image, outline, table.cells);
      if (!cells) {
        continue;
      }
      const auto index = static_cast<int>(code);
      const MarkerOutline edge = grownOutline(outline);
      if (const auto marker = lookedUp(table, *cells, edge)) {
        readings[{index, inverted, false}].push_back(*marker);
      }
      cv::Mat flipped;
      cv::flip(*cells, flipped, 1);
      if (const auto marker = lookedUp(table, flipped, mirroredOutline(edge, image.cols))) {
        readings[{index, inverted, true}].push_back(*marker);
      }
    }
  }
  for (auto& [reading, markers] : readings) {
    keepEachOnce(markers);
  }
  std::erase_if(readings, [](const auto& reading) { return reading.second.empty(); });
  return readings;
}

} // namespace

const std::vector<std::string>& markerCodes() {
  static const std::vector<std::string> kCodes{"DICT_4X4_1000", "DICT_5X5_1000", "DICT_6X6_1000",
                                               "DICT_7X7_1000", "DICT_ARUCO_ORIGINAL"};
  return kCodes;
}

std::map<MarkerReading, std::vector<ReadMarker>> readMarkersInAnyCode(const cv::Mat& gray) {
  MarkerReadings readings = readMarkersAsPrinted(gray, false);
  const auto isBoard = [](const auto& reading) { return reading.second.size() >= kClearlyRead; };
  if (std::ranges::none_of(readings, isBoard)) { // the search takes most of the time
    readings.merge(readMarkersAsPrinted(~gray, true));
  }
  return readings;
}

} // namespace dewpoint::calibration

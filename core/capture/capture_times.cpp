// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_times.h"

#include "core/base/limits.h"
#include "core/base/lower_case.h"
#include "core/base/table_text.h"
#include "core/base/text_number.h"
#include "core/capture/numbered_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace dewpoint::capture {
namespace {

constexpr std::array kTimeColumns{"time", "timestamp", "frame_time", "t"};
constexpr std::array<std::pair<std::string_view, double>, 5> kTimeUnits{
    {{"", 1.0}, {"_s", 1.0}, {"_ms", 1e-3}, {"_us", 1e-6}, {"_ns", 1e-9}}};
constexpr std::array kCameraColumns{"cam_id", "camera", "camera_id", "cam", "port", "device"};

using Cells = std::vector<std::string_view>;

std::string_view trimmedCell(std::string_view text) {
  const auto isOuter = [](char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0 || c == '"';
  };
  while (!text.empty() && isOuter(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && isOuter(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

/// What separates the cells of a line: the first of these that is in it.
char separatorOf(std::string_view line) {
  for (const char separator : {',', ';', '\t', ' '}) {
    if (line.find(separator) != std::string_view::npos) {
      return separator;
    }
  }
  return ',';
}

Cells cellsOf(std::string_view line) {
  const char separator = separatorOf(line);
  Cells cells;
  while (true) {
    const auto end = line.find(separator);
    const std::string_view cell = trimmedCell(line.substr(0, end));
    if (separator != ' ' || !cell.empty()) {
      cells.push_back(cell);
    }
    if (end == std::string_view::npos || cells.size() == limits::kMaxColumns) {
      return cells;
    }
    line.remove_prefix(end + 1);
  }
}

std::optional<double> numberIn(std::string_view cell) {
  const auto number = toNumber<double>(cell);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

struct Columns {
  std::size_t time = 0;
  double unit = 1.0; ///< seconds
  std::optional<std::size_t> camera;
};

/// Nothing: no column is one of times.
std::optional<Columns> columnsOf(const Cells& heading) {
  Columns columns;
  bool isFound = false;
  for (std::size_t k = 0; k < heading.size(); ++k) {
    const std::string name = toLowerCase(heading[k]);
    for (const auto& [ending, unit] : kTimeUnits) {
      const bool isTime =
          std::ranges::any_of(kTimeColumns, [&, ending = ending](const char* column) {
            return name == fmt::format("{}{}", column, ending);
          });
      if (isTime && !isFound) {
        isFound = true;
        columns.time = k;
        columns.unit = unit;
      }
    }
    if (!columns.camera && std::ranges::find(kCameraColumns, name) != kCameraColumns.end()) {
      columns.camera = k;
    }
  }
  return isFound ? std::optional(columns) : std::nullopt;
}

struct TimeLine {
  std::string_view camera;
  double time = 0.0; ///< seconds
};

/// All lines of a table of times; fails by line.
class TimeTable {
public:
  TimeTable(const std::string& file, const std::string& field) : file_(file), field_(field) {}

  Status read(std::string_view text);
  bool namesCameras() const { return columns_ && columns_->camera; }
  const std::vector<TimeLine>& lines() const { return lines_; }

private:
  Status readLine(std::string_view line);

  const std::string& file_;
  const std::string& field_;
  std::size_t number_ = 0;
  std::optional<Columns> columns_;
  std::vector<TimeLine> lines_;
};

Status TimeTable::read(std::string_view text) {
  while (!text.empty()) {
    const auto end = text.find('\n');
    const std::string_view line = trimmedCell(text.substr(0, end));
    ++number_;
    if (!line.empty() && line.front() != '#') {
      if (auto read = readLine(line); !read) {
        return read;
      }
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return {};
}

Status TimeTable::readLine(std::string_view line) {
  const Cells cells = cellsOf(line);
  if (!columns_) {
    if (!numberIn(cells.back())) { // a heading
      columns_ = columnsOf(cells);
      return columns_ ? Status()
                      : failure(ErrorCode::BadValue, file_, field_,
                                "it has no column time_s, frame_time or timestamp");
    }
    columns_ = Columns{cells.size() - 1, 1.0, std::nullopt};
  }
  const std::size_t needed = std::max(columns_->time, columns_->camera.value_or(0));
  const auto time = needed < cells.size() ? numberIn(cells[columns_->time]) : std::nullopt;
  if (!time) {
    return failure(ErrorCode::NotParsed, file_, field_,
                   fmt::format("line {} has no time in column {}", number_, columns_->time + 1));
  }
  if (lines_.size() == limits::kMaxRows) {
    return failure(
        ErrorCode::NotParsed, file_, field_,
        fmt::format("it has more than {1} times, from line {0} on", number_, limits::kMaxRows));
  }
  lines_.push_back(
      {columns_->camera ? cells[*columns_->camera] : std::string_view(), *time * columns_->unit});
  return {};
}

/// Without a last line that was cut off while it was written.
std::string_view wholeLines(std::string_view text) {
  return text.starts_with(kRecordedTimesHeading) ? text.substr(0, text.rfind('\n') + 1) : text;
}

} // namespace

TableCompleteness completenessOf(const std::string& file) {
  const auto text = readTableText(file);
  if (!text || !text->starts_with(kRecordedTimesHeading)) {
    return TableCompleteness::Unknown;
  }
  const std::string_view lines = wholeLines(*text);
  const std::size_t last = lines.rfind('\n', lines.size() - 2) + 1;
  return lines.substr(last).starts_with(kRecordedTimesEnd) ? TableCompleteness::Complete
                                                           : TableCompleteness::CutOff;
}

std::vector<std::string> captureTimeIds(const std::string& camera, const std::string& file) {
  std::vector<std::string> names{camera};
  for (const std::string& name : {std::filesystem::path(file).stem().string(), camera}) {
    if (const auto number = trailingNumber(name)) {
      names.push_back(std::to_string(*number));
    }
  }
  return names;
}

Result<CaptureTimes> readCaptureTimes(const std::string& file, const std::vector<std::string>& ids,
                                      const std::string& field) {
  const auto text = readTableText(file);
  if (!text) {
    Error error = text.error();
    error.field = field;
    return tl::make_unexpected(error);
  }
  TimeTable table(file, field);
  if (auto read = table.read(wholeLines(*text)); !read) {
    return tl::make_unexpected(read.error());
  }
  CaptureTimes times;
  const auto takeThoseOf = [&](std::string_view id) {
    for (const TimeLine& line : table.lines()) {
      if (line.camera == id) {
        times.push_back(line.time);
      }
    }
  };
  if (table.namesCameras()) {
    for (auto id = ids.begin(); id != ids.end() && times.empty(); ++id) {
      takeThoseOf(*id);
    }
  } else {
    takeThoseOf({});
  }
  if (times.empty()) {
    return failure(ErrorCode::BadValue, file, field,
                   table.namesCameras()
                       ? fmt::format("it has no line for camera {}", fmt::join(ids, " or "))
                       : "it contains no time");
  }
  std::ranges::sort(times);
  if (std::ranges::adjacent_find(times) != times.end()) {
    return failure(
        ErrorCode::BadValue, file, field,
        fmt::format("two images have the time {} s", *std::ranges::adjacent_find(times)));
  }
  return times;
}

} // namespace dewpoint::capture

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/clips/clip_table.h"

#include "core/base/text_file.h"
#include "core/base/text_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace dewpoint::experiment {
namespace {

std::vector<std::string> cellsOf(std::string line) {
  if (line.ends_with('\r')) {
    line.pop_back();
  }
  std::vector<std::string> cells(1);
  for (const char letter : line) {
    if (letter == ',') {
      cells.emplace_back();
    } else {
      cells.back().push_back(letter);
    }
  }
  return cells;
}

/// The positions of the named columns in the head line.
Result<std::vector<std::size_t>> columnsIn(const std::vector<std::string>& head,
                                           const std::vector<std::string>& names,
                                           const std::string& file) {
  std::vector<std::size_t> positions;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(head, name);
    if (found == head.end()) {
      return failure(ErrorCode::MissingKey, file, name, "no such column");
    }
    positions.push_back(static_cast<std::size_t>(found - head.begin()));
  }
  return positions;
}

struct NumberedLine {
  std::size_t number = 0; ///< in the file, from 1
  std::vector<std::string> cells;
};

/// The lines that are neither comments nor empty.
Result<std::vector<NumberedLine>> tableLines(const std::filesystem::path& file) {
  const auto text = readTextFile(file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  std::vector<NumberedLine> lines;
  std::istringstream stream(*text);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (std::cmp_greater(number, kMaxClipFrame)) {
      return failure(ErrorCode::NotParsed, file.string(), fmt::format("line {}", number),
                     fmt::format("more than {} lines", kMaxClipFrame));
    }
    if (!line.empty() && line.front() != '#' && line.front() != '\r') {
      lines.push_back({number, cellsOf(line)});
    }
  }
  if (lines.empty()) {
    return failure(ErrorCode::NotParsed, file.string(), "", "a line with column names is expected");
  }
  return lines;
}

} // namespace

Result<ClipTable> readClipTable(const std::filesystem::path& file,
                                const std::vector<std::string>& columns,
                                const std::string& wordColumn) {
  const auto lines = tableLines(file);
  if (!lines) {
    return tl::make_unexpected(lines.error());
  }
  std::vector<std::string> names = columns;
  if (!wordColumn.empty()) {
    names.push_back(wordColumn);
  }
  const auto positions = columnsIn(lines->front().cells, names, file.string());
  if (!positions) {
    return tl::make_unexpected(positions.error());
  }
  ClipTable table;
  for (std::size_t line = 1; line < lines->size(); ++line) {
    const NumberedLine& source = (*lines)[line];
    const auto refuse = [&](const char* why) {
      return failure(ErrorCode::NotParsed, file.string(), fmt::format("line {}", source.number),
                     why);
    };
    if (std::ranges::max(*positions) >= source.cells.size()) {
      return refuse("the row is too short");
    }
    auto& row = table.rows.emplace_back();
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const auto value = toNumber<double>(source.cells[(*positions)[column]]);
      if (!value || !std::isfinite(*value)) {
        return refuse("a number is expected");
      }
      row.push_back(*value);
    }
    if (!wordColumn.empty()) {
      table.wordCells.push_back(source.cells[positions->back()]);
    }
  }
  return table;
}

Status checkFrameColumns(const ClipTable& table, const std::vector<std::string>& names,
                         const std::filesystem::path& file) {
  for (const std::vector<double>& row : table.rows) {
    for (std::size_t column = 0; column < names.size(); ++column) {
      const double number = row[column];
      if (number < 0.0 || number > static_cast<double>(kMaxClipFrame) ||
          number != std::floor(number)) {
        return failure(ErrorCode::NotParsed, file.string(), names[column],
                       fmt::format("{} is not a whole number from 0 to {}", number, kMaxClipFrame));
      }
    }
  }
  return {};
}

} // namespace dewpoint::experiment

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board.h"

#include "core/base/text_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Squares in a row or column.
constexpr int kMostSquares = 200;
constexpr double kLargestSquare = 10.0; // meters: anything above was meant in millimeters

std::vector<std::string> partsOf(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == separator) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

/// What is wrong with the numbers of columns and rows, or nothing.
std::string wrongCounts(const BoardDescription& board) {
  const int least = board.kind == BoardDescription::Kind::Chessboard ? 3 : 2;
  if (std::min(board.columns, board.rows) < least ||
      std::max(board.columns, board.rows) > kMostSquares) {
    return fmt::format("{} to {} columns and rows are possible, found {}x{}", least, kMostSquares,
                       board.columns, board.rows);
  }
  return {};
}

/// What is wrong with "9x6", or nothing.
std::string readCounts(const std::string& text, BoardDescription& board) {
  const auto counts = partsOf(text, 'x');
  const auto columns = toNumber<int>(counts.front());
  const auto rows = toNumber<int>(counts.back());
  if (counts.size() != 2 || !columns || !rows) {
    return fmt::format("COLUMNSxROWS is expected, as 9x6, found '{}'", text);
  }
  board.columns = *columns;
  board.rows = *rows;
  return {};
}

std::string noLength(const char* what, const std::string& text) {
  return fmt::format("the {} size in meters is expected, as 0.025, found '{}'", what, text);
}

std::string wrongLength(const char* what, double length) {
  if (!std::isfinite(length) || length <= 0.0) {
    return noLength(what, fmt::format("{}", length));
  }
  if (length > kLargestSquare) {
    return fmt::format("the {} size is in meters; {} m was probably meant in millimeters", what,
                       length);
  }
  return {};
}

std::string readLength(const std::string& text, const char* what, double& length) {
  const auto number = toNumber<double>(text);
  length = number.value_or(0.0);
  return number ? wrongLength(what, length) : noLength(what, text);
}

std::string wrongMarkers(const BoardDescription& board) {
  if (auto wrong = wrongLength("marker", board.markerSize); !wrong.empty()) {
    return wrong;
  }
  if (board.markerSize >= board.squareSize) {
    return fmt::format("the marker ({} m) must be smaller than the square ({} m)", board.markerSize,
                       board.squareSize);
  }
  const auto& known = markerDictionaries();
  if (std::ranges::find(known, board.dictionary) == known.end()) {
    return fmt::format("unknown dictionary '{}'; known are {}", board.dictionary,
                       fmt::join(known, ", "));
  }
  const int markers = board.columns * board.rows / 2;
  const auto words = partsOf(board.dictionary, '_');
  constexpr int kOriginalSize = 1024; // of the one without a number, DICT_ARUCO_ORIGINAL
  const int size = toNumber<int>(words.back()).value_or(kOriginalSize);
  if (markers > size) {
    return fmt::format("{} has too few markers: the board has {}", board.dictionary, markers);
  }
  return {};
}

std::string readMarkers(const std::vector<std::string>& parts, BoardDescription& board) {
  if (auto wrong = readLength(parts[3], "marker", board.markerSize); !wrong.empty()) {
    return wrong;
  }
  board.dictionary = parts[4];
  return wrongMarkers(board);
}

std::string readFlags(const std::vector<std::string>& parts, std::size_t first,
                      BoardDescription& board) {
  for (std::size_t k = first; k < parts.size(); ++k) {
    if (parts[k] == "legacy" && board.kind == BoardDescription::Kind::Charuco) {
      board.usesLegacyLayout = true;
    } else if (parts[k] == "inverted") {
      board.isInverted = true;
    } else {
      return fmt::format("'{}' is unknown here", parts[k]);
    }
  }
  return {};
}

std::string wrongCorners(const BoardDescription& board) {
  return board.cornerCount() < 4 ? "at least four inner corners are needed" : "";
}

std::string readBoard(const std::string& text, BoardDescription& board) {
  const auto parts = partsOf(text, ':');
  const bool chessboard = parts[0] == "chessboard";
  if (!chessboard && parts[0] != "charuco") {
    return fmt::format("chessboard:... or charuco:... is expected, found '{}'", text);
  }
  board.kind = chessboard ? BoardDescription::Kind::Chessboard : BoardDescription::Kind::Charuco;
  const std::size_t needed = chessboard ? 3 : 5;
  if (parts.size() < needed) {
    return fmt::format("{} is expected, found '{}'",
                       chessboard ? "chessboard:COLUMNSxROWS:SQUARE"
                                  : "charuco:COLUMNSxROWS:SQUARE:MARKER:DICTIONARY[:legacy]",
                       text);
  }
  auto wrong = readCounts(parts[1], board);
  wrong = wrong.empty() ? wrongCounts(board) : wrong;
  wrong = wrong.empty() ? readLength(parts[2], "square", board.squareSize) : wrong;
  wrong = wrong.empty() && !chessboard ? readMarkers(parts, board) : wrong;
  wrong = wrong.empty() ? readFlags(parts, needed, board) : wrong;
  return wrong.empty() ? wrongCorners(board) : wrong;
}

/// What parseBoard() would say of the text of a board.
std::string validationError(const BoardDescription& board) {
  auto wrong = wrongCounts(board);
  wrong = wrong.empty() ? wrongLength("square", board.squareSize) : wrong;
  wrong =
      wrong.empty() && board.kind == BoardDescription::Kind::Charuco ? wrongMarkers(board) : wrong;
  return wrong.empty() ? wrongCorners(board) : wrong;
}

} // namespace

Eigen::Vector3d BoardDescription::corner(int id) const {
  const int offset = kind == Kind::Chessboard ? 0 : 1;
  const int column = id % cornerColumns() + offset;
  const int row = id / cornerColumns() + offset;
  return squareSize * Eigen::Vector3d(column, row, 0.0);
}

Eigen::Vector3d BoardDescription::center() const {
  return 0.5 * (corner(0) + corner(cornerCount() - 1));
}

bool BoardDescription::isBlack(int column, int row) const {
  const bool isFirstSquareWhite = usesLegacyLayout && kind == Kind::Charuco && rows % 2 == 0;
  return ((column + row) % 2 == 0) != isFirstSquareWhite;
}

int BoardDescription::symmetryOrder() const {
  if (kind == Kind::Charuco) {
    return 1;
  }
  if (columns != rows) {
    return (columns + rows) % 2 == 0 ? 2 : 1;
  }
  return columns % 2 == 0 ? 4 : 2;
}

Result<BoardDescription> parseBoard(const std::string& text, const std::string& field) {
  BoardDescription board;
  if (auto wrong = readBoard(text, board); !wrong.empty()) {
    return failure(ErrorCode::BadValue, "", field, wrong);
  }
  return board;
}

Status checkBoard(const BoardDescription& board, const std::string& field) {
  if (auto wrong = validationError(board); !wrong.empty()) {
    return failure(ErrorCode::BadValue, "", field, wrong);
  }
  return {};
}

std::string boardText(const BoardDescription& board) {
  const bool chessboard = board.kind == BoardDescription::Kind::Chessboard;
  std::string text = fmt::format("{}:{}x{}:{}", chessboard ? "chessboard" : "charuco",
                                 board.columns, board.rows, board.squareSize);
  if (!chessboard) {
    text += fmt::format(":{}:{}{}", board.markerSize, board.dictionary,
                        board.usesLegacyLayout ? ":legacy" : "");
  }
  return text + (board.isInverted ? ":inverted" : "");
}

const std::vector<std::string>& markerDictionaries() {
  // In the order of OpenCV's enumeration, which gives them their numbers.
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const char* bits : {"4X4", "5X5", "6X6", "7X7"}) {
      for (const char* size : {"50", "100", "250", "1000"}) {
        names.push_back(fmt::format("DICT_{}_{}", bits, size));
      }
    }
    names.emplace_back("DICT_ARUCO_ORIGINAL");
    return names;
  }();
  return kNames;
}

Eigen::Isometry3d worldFromFlatBoard() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return pose;
}

} // namespace dewpoint::calibration

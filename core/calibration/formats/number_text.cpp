// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/number_text.h"

#include "core/base/text_number.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <vector>

namespace dewpoint::calibration {

std::string numberText(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find('.') == std::string::npos && std::isfinite(value)) {
    const auto exponent = text.find('e');
    text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  }
  return text;
}

std::string listText(std::span<const double> values) {
  std::string text = "[";
  for (const double value : values) {
    text += (text.size() > 1 ? ", " : "") + numberText(value);
  }
  return text + "]";
}

std::string listText(const Eigen::VectorXd& values) {
  return listText(std::span(values.data(), std::size_t(values.size())));
}

std::string matrixListText(const Eigen::MatrixXd& matrix) {
  std::string text = "[";
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    text += (row > 0 ? ", " : "") + listText(Eigen::VectorXd(matrix.row(row)));
  }
  return text + "]";
}

std::optional<double> parseNumber(std::string_view text) {
  const auto blank = [](char letter) { return letter == ' ' || letter == '\t' || letter == '\r'; };
  while (!text.empty() && blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && blank(text.back())) {
    text.remove_suffix(1);
  }
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  if (text == ".Nan" || text == ".nan" || text == ".NaN" || text == ".NAN") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (text == ".Inf" || text == ".inf" || text == "-.Inf" || text == "-.inf") {
    return (text.front() == '-' ? -1.0 : 1.0) * std::numeric_limits<double>::infinity();
  }
  return toNumber<double>(text);
}

bool hasLineStartingWith(std::string_view text, std::string_view start) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.starts_with(start)) {
      return true;
    }
    at = end + 1;
  }
  return false;
}

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dewpoint::calibration {

/// Text of a number that reads back to the same bits, always with a decimal point: some YAML
/// readers take "1e-05" for a string, and some TOML readers reject arrays that mix "0" with "0.5".
std::string numberText(double value);

/// Text of a list on one line: "[1.0, 2.0, 3.0]".
std::string listText(std::span<const double> values);
std::string listText(const Eigen::VectorXd& values);

/// Text of a matrix, row by row: "[[...], [...], [...]]".
std::string rowsText(const Eigen::MatrixXd& matrix);

/// Parses a number written by any tool, in the C locale: also "1.", "+2", ".5", "nan". Nothing if
/// the text contains anything else.
std::optional<double> numberOf(std::string_view text);

/// Returns true if a line of the text begins with `start` after its indentation.
bool hasLine(std::string_view text, std::string_view start);

} // namespace dewpoint::calibration

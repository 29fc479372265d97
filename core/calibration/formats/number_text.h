// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dewpoint::calibration {

/// Returns the text of a number. Reading it yields exactly the same bits. The text always has a
/// decimal point, because some YAML readers take "1e-05" for a string, and some TOML readers reject
/// arrays that mix "0" and "0.5".
std::string numberText(double value);

/// Returns the text of a list on one line: "[1.0, 2.0, 3.0]".
std::string listText(std::span<const double> values);
std::string listText(const Eigen::VectorXd& values);

/// Returns the text of a matrix, row by row: "[[...], [...], [...]]".
std::string matrixListText(const Eigen::MatrixXd& matrix);

/// Parses a number written by any tool, in the C locale, including "1.", "+2", ".5" and "nan".
/// Returns nothing if the text contains anything else.
std::optional<double> parseNumber(std::string_view text);

/// Returns whether any line of the text begins with `start` after its indentation.
bool hasLineStartingWith(std::string_view text, std::string_view start);

} // namespace dewpoint::calibration

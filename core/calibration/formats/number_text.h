// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dewpoint::calibration {

/// A number that reads back to the same bits, always with a decimal point: some readers of YAML
/// take "1e-05" for a text, and some of TOML refuse arrays that mix "0" with "0.5".
std::string numberText(double value);

/// "[1.0, 2.0, 3.0]", on one line.
std::string listText(std::span<const double> values);
std::string listText(const Eigen::VectorXd& values);

/// "[[...], [...], [...]]", row by row.
std::string rowsText(const Eigen::MatrixXd& matrix);

/// A number of any tool's text, in the C locale: also "1.", "+2", ".5", "nan". Nothing else around.
std::optional<double> numberOf(std::string_view text);

/// True when a line of the text, after its indentation, begins with `start`.
bool hasLine(std::string_view text, std::string_view start);

} // namespace dewpoint::calibration

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::app {

/// A text as it stands in a cell of a table or in a paragraph: signs that mean something in
/// Markdown or HTML mean themselves.
std::string markdownText(std::string_view text);

/// A text between backticks.
std::string markdownCode(std::string_view text);

/// A table; every row has as many cells as the head. Cells are Markdown already.
std::string markdownTable(const std::vector<std::string>& head,
                          const std::vector<std::vector<std::string>>& rows);

} // namespace dewpoint::app

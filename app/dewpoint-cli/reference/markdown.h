// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::app {

/// Escapes a string for a table cell or a paragraph, so that special characters of Markdown and
/// HTML are shown literally.
std::string markdownText(std::string_view text);

/// Returns a string as Markdown code, between backticks.
std::string markdownCode(std::string_view text);

/// Returns a Markdown table. Every row must have as many cells as the header, and cells must
/// already be Markdown.
std::string markdownTable(const std::vector<std::string>& head,
                          const std::vector<std::vector<std::string>>& rows);

} // namespace dewpoint::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace dewpoint::project {

/// Receiver of datagrams.
struct OutputAddress {
  std::string host; ///< name or address; an IPv6 address without its brackets
  std::uint16_t port = 0;
};

/// Parses HOST:PORT, where an IPv6 address is in brackets. BadValue if it is something else.
Result<OutputAddress> parseOutputAddress(std::string_view text);

/// Return the axes or the unit of a name in the project file; nothing for an unknown name.
std::optional<OutputAxes> outputAxes(std::string_view name);
std::optional<OutputUnit> outputUnit(std::string_view name);
/// Return the name in the project file.
const char* nameOf(OutputAxes axes);
const char* nameOf(OutputUnit unit);

/// Reads the table [output] of a project file.
void readOutput(TableReader& reader, const std::string& file, Project& project);
/// Returns the same table as TOML; empty if everything has its default.
std::string outputText(const OutputSettings& output);
/// Checks rate, addresses and token. BadValue names the key, as "output.osc".
Status checkOutput(const OutputSettings& output);

} // namespace dewpoint::project

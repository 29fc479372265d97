// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::capture {

/// Parts of a network address such as http://user:password@host:8080/video?size=2. Missing parts
/// are empty.
struct ParsedAddress {
  std::string scheme; ///< scheme in lower case, without ://
  std::string user;   ///< user name, with percent escapes decoded
  std::string password;
  std::string host;             ///< host name or address, without the brackets of an IPv6 address
  std::optional<int> port = {}; ///< port number, 1 to 65535
  std::string path;             ///< text from the first / after the host, including the query
  /// Options in the query, with percent escapes decoded.
  std::vector<std::pair<std::string, std::string>> options = {};

  /// Returns the value of an option in the query, or nothing.
  std::optional<std::string> option(std::string_view name) const;
  /// Returns the address without user and password.
  std::string withoutUser() const;
};

/// Splits an address into its parts. Returns nothing if the address has no scheme or an invalid
/// port.
std::optional<ParsedAddress> parseAddress(std::string_view address);

/// Returns the names and values of the options in a query such as name=value&name=value, with
/// percent escapes decoded.
std::vector<std::pair<std::string, std::string>> queryOptions(std::string_view query);

} // namespace dewpoint::capture

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::capture {

/// Parts of a network address such as http://user:password@host:8080/video?size=2. Those that are
/// missing are empty.
struct AddressParts {
  std::string scheme; ///< in lower case, without ://
  std::string user;   ///< percent escapes are decoded
  std::string password;
  std::string host;             ///< without the brackets of an IPv6 address
  std::optional<int> port = {}; ///< 1 to 65535
  std::string path;             ///< from the first / after the host, with the query
  std::vector<std::pair<std::string, std::string>> options = {}; ///< of the query; decoded

  /// Returns the value of an option in the query, or nothing.
  std::optional<std::string> option(std::string_view name) const;
  /// Returns the address without user and password.
  std::string withoutUser() const;
};

/// Splits an address into its parts; nothing if it has no scheme, or a port that is not valid.
std::optional<AddressParts> addressParts(std::string_view address);

/// Splits the options name=value&name=value of a query; percent escapes are decoded.
std::vector<std::pair<std::string, std::string>> queryOptions(std::string_view query);

} // namespace dewpoint::capture

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/address_parts.h"

#include "core/base/lower_case.h"
#include "core/base/text_number.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace dewpoint::capture {
namespace {

constexpr int kLargestPort = 65535;

std::string percentDecoded(std::string_view text) {
  std::string decoded;
  for (std::size_t k = 0; k < text.size(); ++k) {
    unsigned int byte = 0;
    const char* const begin = text.data() + k + 1;
    if (text[k] == '%' && k + 2 < text.size() &&
        std::from_chars(begin, begin + 2, byte, 16).ptr == begin + 2) {
      decoded += static_cast<char>(byte);
      k += 2;
    } else {
      decoded += text[k];
    }
  }
  return decoded;
}

/// host, host:port, [v6] or [v6]:port
bool readHost(std::string_view text, ParsedAddress& parts) {
  std::string_view port;
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) {
      return false;
    }
    parts.host = text.substr(1, end - 1);
    port = text.substr(end + 1);
  } else {
    const std::size_t colon = text.find(':');
    parts.host = text.substr(0, colon);
    port = colon == std::string_view::npos ? std::string_view() : text.substr(colon);
  }
  if (port.empty() || port == ":") {
    return true;
  }
  parts.port = toNumber<int>(port.substr(1));
  return port.front() == ':' && parts.port && *parts.port > 0 && *parts.port <= kLargestPort;
}

} // namespace

std::optional<std::string> ParsedAddress::option(std::string_view name) const {
  const auto found = std::ranges::find(options, name, [](const auto& pair) { return pair.first; });
  return found != options.end() ? std::optional(found->second) : std::nullopt;
}

std::string ParsedAddress::withoutUser() const {
  const bool isV6 = host.find(':') != std::string::npos;
  return scheme + "://" + (isV6 ? "[" + host + "]" : host) +
         (port ? ":" + std::to_string(*port) : "") + path;
}

std::vector<std::pair<std::string, std::string>> queryOptions(std::string_view query) {
  std::vector<std::pair<std::string, std::string>> options;
  while (!query.empty()) {
    const std::string_view one = query.substr(0, query.find('&'));
    const std::size_t equals = one.find('=');
    if (!one.empty()) {
      options.emplace_back(percentDecoded(one.substr(0, equals)),
                           equals == std::string_view::npos
                               ? std::string()
                               : percentDecoded(one.substr(equals + 1)));
    }
    query.remove_prefix(std::min(one.size() + 1, query.size()));
  }
  return options;
}

std::optional<ParsedAddress> parseAddress(std::string_view address) {
  const std::size_t separator = address.find("://");
  if (separator == std::string_view::npos || separator == 0) {
    return std::nullopt;
  }
  ParsedAddress parts;
  parts.scheme = toLowerCase(address.substr(0, separator));
  address.remove_prefix(separator + 3);
  const std::size_t end = std::min(address.find_first_of("/?#"), address.size());
  std::string_view host = address.substr(0, end);
  parts.path = address.substr(end);
  // A password may contain further such signs: the host begins after the last one.
  if (const std::size_t at = host.rfind('@'); at != std::string_view::npos) {
    const std::string_view user = host.substr(0, at);
    const std::size_t colon = user.find(':');
    parts.user = percentDecoded(user.substr(0, colon));
    parts.password =
        colon == std::string_view::npos ? std::string() : percentDecoded(user.substr(colon + 1));
    host.remove_prefix(at + 1);
  }
  if (!readHost(host, parts)) {
    return std::nullopt;
  }
  const std::size_t query = parts.path.find('?');
  if (query != std::string::npos) {
    const std::string_view rest = std::string_view(parts.path).substr(query + 1);
    parts.options = queryOptions(rest.substr(0, rest.find('#')));
  }
  return parts;
}

} // namespace dewpoint::capture

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/namespace_rule.h"

#include <set>
#include <sstream>

namespace dewpoint::tests {

std::string namespaceOf(const std::string& path) {
  // They hold includes only, or nothing but what main() needs, in an unnamed namespace.
  static const std::set<std::string> kNone = {"app/dewpoint-cli/precompiled.h",
                                              "app/dewpoint/main.cpp", "core/precompiled.h",
                                              "ui/precompiled.h"};
  if (kNone.contains(path)) {
    return {};
  }
  if (path.starts_with("ui/")) {
    return "dewpoint::ui";
  }
  if (path.starts_with("app/")) {
    return "dewpoint::app";
  }
  const std::string core = "core/";
  return path.starts_with(core)
             ? "dewpoint::" + path.substr(core.size(), path.find('/', core.size()) - core.size())
             : "";
}

bool opensItsNamespace(const std::string& path, std::string_view text) {
  const std::string name = namespaceOf(path);
  if (name.empty()) {
    return true;
  }
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("namespace " + name + " {") ||
        line.starts_with("namespace " + name + "::")) {
      return true;
    }
  }
  return false;
}

} // namespace dewpoint::tests

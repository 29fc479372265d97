// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/parameter_settings.h"

namespace dewpoint::app {

Status applySettings(const std::vector<std::string>& settings, ParameterValues& parameters) {
  for (const auto& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos) {
      return failure(ErrorCode::BadValue, "", "--set", "expected key=value, found " + setting);
    }
    if (auto set = parameters.setFromText(setting.substr(0, equals), setting.substr(equals + 1));
        !set) {
      set.error().file = "--set";
      return set;
    }
  }
  return {};
}

} // namespace dewpoint::app

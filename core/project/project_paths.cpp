// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_paths.h"

#include <cstdlib>
#include <cstring>

namespace dewpoint::project {

Result<std::string> expandVariables(std::string text) {
  for (auto begin = text.find("${"); begin != std::string::npos; begin = text.find("${", begin)) {
    const auto end = text.find('}', begin);
    const std::string name =
        text.substr(begin + 2, end == std::string::npos ? end : end - begin - 2);
    const char* value = end == std::string::npos ? nullptr : std::getenv(name.c_str());
    if (value == nullptr) {
      return failure(ErrorCode::BadValue, "", "",
                     "the environment variable " + name + " is not set");
    }
    text.replace(begin, end - begin + 1, value);
    begin += std::strlen(value); // what it stands for is not expanded again
  }
  return text;
}

std::filesystem::path ProjectPaths::pathOf(const std::string& name) const {
  const std::filesystem::path named = (folder / name).lexically_normal();
  const auto found = movedFiles.find(named);
  return found != movedFiles.end() ? found->second : named;
}

} // namespace dewpoint::project

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/token_file.h"

#include "core/base/text_file.h"

namespace dewpoint::app {

Result<std::string> readTokenFile(const std::string& file) {
  return readTextFile(file).and_then([&](const std::string& text) -> Result<std::string> {
    std::string token = text.substr(0, text.find_first_of("\r\n"));
    if (token.empty()) {
      return failure(ErrorCode::BadValue, file, "", "the first line is empty");
    }
    return token;
  });
}

} // namespace dewpoint::app

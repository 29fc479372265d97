// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace dewpoint::base {

/// A file that is written while something runs. Each piece goes to the operating system at once, so
/// that what a killed program wrote can be read. Errors are FileUnwritable with the reason, of a
/// full disk for instance.
class GrowingFile {
public:
  /// Creates the file, or empties it.
  static Result<GrowingFile> create(const std::filesystem::path& path);

  Status append(std::string_view text);
  /// Closes it; nothing may be appended after it.
  Status close();

private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  GrowingFile(std::string name, std::FILE* file) : name_(std::move(name)), file_(file) {}
  tl::unexpected<Error> unwritable(int reason) const;

  std::string name_;
  std::unique_ptr<std::FILE, Close> file_;
};

} // namespace dewpoint::base

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

/// File that is written piece by piece while the program runs. Each piece is passed to the
/// operating system immediately, so the file is readable even if the program is killed. Errors are
/// FileUnwritable with the reason, for instance a full disk.
class GrowingFile {
public:
  /// Creates the file, or empties an existing file.
  static Result<GrowingFile> create(const std::filesystem::path& path);

  /// Appends text and passes it to the operating system immediately.
  Status append(std::string_view text);
  /// Closes the file. Nothing may be appended afterwards.
  Status close();

private:
  struct FileCloser {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  GrowingFile(std::string name, std::FILE* file) : name_(std::move(name)), file_(file) {}
  tl::unexpected<Error> writeError(int reason) const;

  std::string name_;
  std::unique_ptr<std::FILE, FileCloser> file_;
};

} // namespace dewpoint::base

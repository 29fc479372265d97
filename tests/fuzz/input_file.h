// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace dewpoint::tests {

/// A file that holds other bytes for each input of a fuzzer. It is in a folder of this process in
/// memory, which goes when the process ends.
class InputFile {
public:
  /// `name` may have folders in it, which are made.
  explicit InputFile(const std::string& name);
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  /// Writes the bytes in place of those before; ends the process when that fails.
  const std::filesystem::path& hold(std::string_view bytes) const;
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// The folder of all InputFiles of this process.
const std::filesystem::path& inputFolder();

} // namespace dewpoint::tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/input_file.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

class InputFolder {
public:
  InputFolder() {
    const fs::path memory = "/dev/shm";
    std::error_code ignored;
    const fs::path parent = fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path();
    path_ = parent / fmt::format("dewpoint-fuzz-{}", ::getpid());
    fs::create_directories(path_);
  }
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;
  ~InputFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

private:
  fs::path path_;
};

} // namespace

const std::filesystem::path& inputFolder() {
  static const InputFolder kFolder;
  return kFolder.path();
}

InputFile::InputFile(const std::string& name) : path_(inputFolder() / name) {
  fs::create_directories(path_.parent_path());
  descriptor_ = ::open(path_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
}

InputFile::~InputFile() {
  ::close(descriptor_);
}

const std::filesystem::path& InputFile::hold(std::string_view bytes) const {
  if (::ftruncate(descriptor_, 0) != 0 ||
      ::pwrite(descriptor_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    fmt::print(stderr, "{} cannot be written\n", path_.string());
    std::abort();
  }
  return path_;
}

} // namespace dewpoint::tests

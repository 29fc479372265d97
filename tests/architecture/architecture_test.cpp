// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/source_rules.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sourceFiles() {
  std::vector<fs::path> files;
  for (const char* folder : {"core", "ui", "app", "translations", "tests", "bench"}) {
    const fs::path top = fs::path(DEWPOINT_SOURCE_DIR) / folder;
    if (!fs::exists(top)) {
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(top)) {
      const std::string extension = entry.path().extension().string();
      if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp")) {
        files.push_back(entry.path());
      }
    }
  }
  return files;
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// How many complaints a file at `path` with just this include gets.
std::size_t complaints(const std::string& path, const std::string& include) {
  return violations(path, "#include " + include + "\n").size();
}

TEST(Architecture, EveryFileKeepsTheRules) {
  const std::vector<fs::path> files = sourceFiles();
  ASSERT_GT(files.size(), 20U) << "the sources were not found under " << DEWPOINT_SOURCE_DIR;
  for (const fs::path& file : files) {
    const std::string path = fs::relative(file, DEWPOINT_SOURCE_DIR).generic_string();
    for (const std::string& violation : violations(path, contents(file))) {
      ADD_FAILURE() << violation;
    }
  }
}

TEST(Architecture, OwnHeadersAreIncludedByTheirFullPath) {
  for (const fs::path& file : sourceFiles()) {
    const std::string path = fs::relative(file, DEWPOINT_SOURCE_DIR).generic_string();
    for (const std::string& include : includesOf(contents(file))) {
      const bool own =
          include.starts_with("core/") || include.starts_with("ui/") || include.starts_with("app/");
      EXPECT_TRUE(!own || fs::exists(fs::path(DEWPOINT_SOURCE_DIR) / include))
          << path << " includes " << include << ", which does not exist";
      EXPECT_FALSE(include.starts_with("../")) << path << " includes " << include;
    }
  }
}

TEST(SourceRules, FindsIncludesAndIgnoresComments) {
  const auto names = includesOf("#include <vector>\n  # include \"core/base/time.h\" // why\n"
                                "// #include <QWidget>\n/*\n#include <vtkActor.h>\n*/\n"
                                "#include <map>\n");
  EXPECT_EQ(names, (std::vector<std::string>{"vector", "core/base/time.h", "map"}));
}

TEST(SourceRules, ArrowsDownPass) {
  EXPECT_EQ(complaints("core/session/session.cpp", "\"core/tracking/tracker.h\""), 0U);
  EXPECT_EQ(complaints("core/session/session.cpp", "\"core/geometry/camera.h\""), 0U);
  EXPECT_EQ(complaints("core/observation/a.h", "\"core/filter/particles.h\""), 0U);
  EXPECT_EQ(complaints("core/filter/a.h", "\"core/base/random.h\""), 0U);
  EXPECT_EQ(complaints("core/tracking/tracker.h", "\"core/capture/frame.h\""), 0U);
  EXPECT_EQ(complaints("ui/camera/view.h", "\"core/session/run/snapshot.h\""), 0U);
  EXPECT_EQ(complaints("ui/camera/view.h", "<QWidget>"), 0U);
  EXPECT_EQ(complaints("ui/birdseye/view.cpp", "\"ui/scene3d/scene.h\""), 0U);
  EXPECT_EQ(complaints("ui/scene3d/scene.cpp", "<vtkActor.h>"), 0U);
  EXPECT_EQ(complaints("app/dewpoint/main.cpp", "\"ui/mainwindow/main_window.h\""), 0U);
}

TEST(SourceRules, ArrowsUpAndAcrossFail) {
  EXPECT_EQ(complaints("core/base/error.h", "\"core/geometry/camera.h\""), 1U);
  EXPECT_EQ(complaints("core/tracking/tracker.h", "\"core/session/session.h\""), 1U);
  EXPECT_EQ(complaints("core/filter/a.h", "\"core/color/color_range.h\""), 1U);
  EXPECT_EQ(complaints("core/color/a.h", "\"core/geometry/camera.h\""), 1U);
  EXPECT_EQ(complaints("core/tracking/tracker.h", "\"core/capture/frame_source.h\""), 1U);
  EXPECT_EQ(complaints("core/session/session.h", "\"core/simulation/scene.h\""), 1U);
  EXPECT_EQ(complaints("core/session/session.h", "\"ui/bridge/bridge.h\""), 1U);
  EXPECT_EQ(complaints("ui/camera/view.h", "\"core/filter/particles.h\""), 1U);
  EXPECT_EQ(complaints("ui/camera/view.h", "\"app/wiring/wiring.h\""), 1U);
  EXPECT_EQ(complaints("ui/camera/view.h", "\"ui/mainwindow/main_window.h\""), 1U);
  EXPECT_EQ(complaints("app/dewpoint-cli/main.cpp", "\"ui/bridge/bridge.h\""), 1U);
  EXPECT_EQ(complaints("core/secret/a.h", "<vector>"), 1U) << "a folder that is not a floor";
}

TEST(SourceRules, ForeignLibrariesStayWhereTheyBelong) {
  EXPECT_EQ(complaints("core/session/a.h", "<QObject>"), 1U);
  EXPECT_EQ(complaints("core/session/a.h", "<QtCore/QObject>"), 1U);
  EXPECT_EQ(complaints("core/session/a.h", "<qglobal.h>"), 1U);
  EXPECT_EQ(complaints("core/tracking/a.h", "<vtkActor.h>"), 1U);
  EXPECT_EQ(complaints("core/filter/a.h", "<opencv2/core.hpp>"), 1U);
  EXPECT_EQ(complaints("core/color/a.h", "<opencv2/core.hpp>"), 0U);
  EXPECT_EQ(complaints("ui/scene3d/scene.h", "<QColor>"), 1U);
  EXPECT_EQ(complaints("ui/plots/plot.h", "<vtkActor.h>"), 1U);
  EXPECT_EQ(complaints("app/dewpoint-cli/main.cpp", "<QString>"), 1U);
}

TEST(SourceRules, LongFilesFail) {
  const auto lines = [](int count) { return std::string(static_cast<std::size_t>(count), '\n'); };
  EXPECT_TRUE(violations("core/base/a.h", lines(kLineLimit)).empty());
  EXPECT_EQ(violations("core/base/a.h", lines(kLineLimit + 1)).size(), 1U);
}

} // namespace
} // namespace dewpoint::tests

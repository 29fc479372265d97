// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/namespace_rule.h"
#include "tests/architecture/source_rules.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

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

/// A file with nothing but its namespace.
std::string emptyFile(const std::string& path) {
  const std::string home = namespaceOf(path);
  return home.empty() ? "" : "namespace " + home + " {}\n";
}

/// How many complaints a file at `path` with just this include gets.
std::size_t complaints(const std::string& path, const std::string& include) {
  return violations(path, "#include " + include + "\n" + emptyFile(path)).size();
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

/// How many questions `count` finds in core, ui and app outside of the catalog of methods; where
/// they are is appended to `places`.
template <class Count> int questionsOutsideTheCatalog(const Count& count, std::string& places) {
  int questions = 0;
  for (const fs::path& file : sourceFiles()) {
    const std::string path = fs::relative(file, DEWPOINT_SOURCE_DIR).generic_string();
    const bool counts =
        path.starts_with("core/") || path.starts_with("ui/") || path.starts_with("app/");
    if (counts && !path.starts_with("core/tracking/catalog/")) {
      const int found = count(contents(file));
      questions += found;
      places += found > 0 ? "\n  " + path + ": " + std::to_string(found) : "";
    }
  }
  return questions;
}

// kindQuestions() finds places by the names of these types, so a type with another name would hide
// them.
TEST(Architecture, TheTypesThatNameAKindOfMethodsExist) {
  const fs::path catalog = fs::path(DEWPOINT_SOURCE_DIR) / "core/tracking/catalog/method_catalog.h";
  for (const char* type : {"TargetSource", "RunTableKind"}) {
    EXPECT_NE(contents(catalog).find(std::string("enum class ") + type + " {"), std::string::npos)
        << type;
    EXPECT_EQ(kindQuestions(std::string(type) + "::A\n"), 1) << type;
  }
}

// A new kind of methods is to be added in the catalog and in few other places.
TEST(Architecture, FewPlacesAskOfWhichKindAMethodIs) {
  constexpr int kMost = 9;
  std::string places;
  const int questions = questionsOutsideTheCatalog(kindQuestions, places);
  EXPECT_LE(questions, kMost) << "let MethodFamily answer what is to be known, and visit estimates:"
                              << places;
  EXPECT_GT(questions, 0);
}

// These functions only compare the kind, and no more code should depend on it.
TEST(Architecture, FewPlacesCallAFunctionThatComparesTheKind) {
  struct Limit {
    const char* call;
    int most;
  };
  constexpr Limit kLimits[] = {{"findsTargets()", 7},      {"hasColorMasks()", 5},
                               {"writesPositions()", 3},   {"writesBodies()", 2},
                               {"get_if<BoxEstimate>", 2}, {"get_if<PersonEstimate>", 2}};
  for (const Limit& limit : kLimits) {
    std::string places;
    const int calls = questionsOutsideTheCatalog(
        [&](std::string_view text) { return occurrencesOf(limit.call, text); }, places);
    EXPECT_LE(calls, limit.most) << limit.call
                                 << ": let MethodFamily answer what is to be known, and visit "
                                    "estimates:"
                                 << places;
    EXPECT_GT(calls, 0) << limit.call;
  }
}

TEST(SourceRules, CountsQuestionsForTheKindOfAMethod) {
  EXPECT_EQ(kindQuestions("  if (family.tables == RunTableKind::Boxes) {\n"), 1);
  EXPECT_EQ(kindQuestions("f(TargetSource::Box, TargetSource::Color);\n"), 2);
  EXPECT_EQ(kindQuestions("  // as RunTableKind::Boxes\n"), 0);
  EXPECT_EQ(kindQuestions("  switch (family.tables) {\n  case RunTableKind::Boxes:\n    break;\n"
                          "  case RunTableKind::People:\n    break;\n"),
            1);
  EXPECT_EQ(kindQuestions("  if (run.capability<Copyable>() == nullptr) {\n"), 1);
  EXPECT_EQ(kindQuestions("  const auto* const copying = run.capability<Copyable>();\n"
                          "  if (copying != nullptr) {\n"),
            0);
}

TEST(SourceRules, CountsQuestionsForTheKindOfAnEstimate) {
  EXPECT_EQ(kindQuestions("  if (target.box() == nullptr) {\n"), 1);
  EXPECT_EQ(kindQuestions("  return target->person() != nullptr && other.person();\n"), 2);
  EXPECT_EQ(kindQuestions("  if (const PersonEstimate* person = target.person()) {\n"), 1);
  EXPECT_EQ(kindQuestions("  // as target.box() == nullptr\n"), 0);
  EXPECT_EQ(kindQuestions("  return target.box()->camera;\n"), 0); // it is known to be one
  EXPECT_EQ(kindQuestions("  const BoxEstimate* box() const {\n"), 0);
}

TEST(SourceRules, CountsQuestionsForTargetsThatAreFound) {
  const auto questions = [](const char* text) { return occurrencesOf("findsTargets()", text); };
  EXPECT_EQ(questions("  return a.findsTargets() || b.findsTargets();\n"), 2);
  EXPECT_EQ(questions("  // as family.findsTargets()\n"), 0);
  EXPECT_EQ(questions("  const bool findsTargets = true;\n"), 0);
}

// Dividing a class over files would only hide that it has grown; divide what it is responsible for.
TEST(Architecture, AClassOfTheWindowIsOnePairOfFiles) {
  static const std::regex kClass("(?:^|\\n)(?:class|struct) ([A-Z]\\w*)[^;]*\\{");
  std::map<std::string, std::set<std::string>> files;
  std::set<std::string> own;
  for (const fs::path& file : sourceFiles()) {
    const std::string path = fs::relative(file, DEWPOINT_SOURCE_DIR).generic_string();
    if (path.starts_with("ui/") && path.ends_with(".cpp")) {
      for (const std::string& name : classesDefinedIn(contents(file))) {
        files[name].insert(path);
      }
    } else if (path.starts_with("ui/")) {
      const std::string text = contents(file);
      for (std::sregex_iterator match(text.begin(), text.end(), kClass), end; match != end;
           ++match) {
        own.insert((*match)[1]);
      }
    }
  }
  std::erase_if(files, [&](const auto& entry) { return !own.contains(entry.first); });
  EXPECT_GT(files.size(), 50U);
  for (const auto& [name, all] : files) {
    EXPECT_EQ(all.size(), 1U) << name << " is defined in " << *all.begin() << " and in "
                              << *all.rbegin();
  }
}

TEST(SourceRules, FindsTheClassesOfDefinitions) {
  const auto names = classesDefinedIn("MainWindow::MainWindow(QWidget* parent)\n"
                                      "MainWindow::~MainWindow() = default;\n"
                                      "const std::vector<Dock>& DockManager::docks() const {\n"
                                      "  Timeline::show(1);\n"
                                      "Session::Impl::Impl(int);\n"
                                      "// Plot::draw( in a comment\n"
                                      "std::string encoders::text(int) {\n"
                                      "void free(Target::Kind kind) {\n");
  EXPECT_EQ(names, (std::set<std::string>{"MainWindow", "DockManager", "Session"}));
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
  EXPECT_EQ(complaints("core/observation/sphere/a.h", "\"core/filter/particles.h\""), 0U);
  EXPECT_EQ(complaints("core/filter/a.h", "\"core/base/random.h\""), 0U);
  EXPECT_EQ(complaints("core/tracking/tracker.h", "\"core/capture/frame.h\""), 0U);
  EXPECT_EQ(complaints("core/project/project.h", "\"core/capture/device_settings.h\""), 0U);
  EXPECT_EQ(complaints("ui/cameraview/view.h", "\"core/session/snapshot/snapshot.h\""), 0U);
  EXPECT_EQ(complaints("ui/cameraview/view.h", "<QWidget>"), 0U);
  EXPECT_EQ(complaints("ui/view3d/view.cpp", "\"ui/scene3d/scene.h\""), 0U);
  EXPECT_EQ(complaints("ui/scene3d/scene.cpp", "<vtkActor.h>"), 0U);
  EXPECT_EQ(complaints("app/dewpoint/main.cpp", "\"ui/mainwindow/main_window.h\""), 0U);
  const std::string job = "\"app/dewpoint-cli/track/track_job.h\"";
  EXPECT_EQ(complaints("app/dewpoint-cli/track/track_command.cpp", job), 0U);
}

TEST(SourceRules, FilesBesideTheRoomsFail) {
  EXPECT_EQ(complaints("core/secret/a.h", "<vector>"), 1U) << "a folder that is not a floor";
  EXPECT_EQ(complaints("core/simulation/a.h", "<vector>"), 1U) << "beside the rooms";
  EXPECT_EQ(complaints("core/calibration/a.h", "<vector>"), 1U) << "beside the rooms";
  EXPECT_EQ(complaints("core/calibration/cellar/a.h", "<vector>"), 1U) << "no such room";
  EXPECT_EQ(complaints("core/geometry/cellar/a.h", "<vector>"), 1U) << "a floor without rooms";
  EXPECT_EQ(complaints("core/experiment/scenarios/cellar/a.h", "<vector>"), 1U) << "no such room";
  EXPECT_EQ(complaints("ui/attic/a.h", "<vector>"), 1U) << "no such room";
}

TEST(SourceRules, RoomsOfAFloorIncludeThoseBelow) {
  EXPECT_EQ(complaints("core/calibration/board/a.h", "\"core/calibration/bundle/b.h\""), 0U);
  EXPECT_EQ(complaints("core/calibration/bundle/a.h", "\"core/calibration/bundle/b.h\""), 0U);
  EXPECT_EQ(complaints("core/session/session.h", "\"core/session/snapshot/snapshot.h\""), 0U);
  EXPECT_EQ(complaints("core/tracking/catalog/a.cpp", "\"core/tracking/people/b.h\""), 0U);
  EXPECT_EQ(complaints("core/color/likelihood/a.h", "\"core/color/b.h\""), 0U);
  EXPECT_EQ(complaints("core/trajectory/figure/a.h", "\"core/trajectory/export/b.h\""), 0U);
  EXPECT_EQ(complaints("core/experiment/studies/a.h", "\"core/experiment/boxes/b.h\""), 0U);
}

TEST(SourceRules, RoomsInsideARoomIncludeThoseBelow) {
  const std::string scenarios = "core/experiment/scenarios/";
  EXPECT_EQ(complaints(scenarios + "catalog/a.h", "\"" + scenarios + "draft/b.h\""), 0U);
  EXPECT_EQ(complaints("core/experiment/studies/a.h", "\"" + scenarios + "people/b.h\""), 0U);
  EXPECT_EQ(complaints("core/experiment/suite/a.h", "\"" + scenarios + "catalog/b.h\""), 0U);

  const std::string dewpoint = "core/tracking/dewpoint/";
  EXPECT_EQ(complaints(dewpoint + "a.h", "\"" + dewpoint + "track/b.h\""), 0U);
  EXPECT_EQ(complaints(dewpoint + "track/a.h", "\"" + dewpoint + "search/b.h\""), 0U);
}

TEST(SourceRules, RoomsOfTheWindowIncludeThoseBelow) {
  EXPECT_EQ(complaints("ui/widgets/a.h", "\"ui/style/theme.h\""), 0U);
  EXPECT_EQ(complaints("ui/color/a.h", "\"ui/cameraview/b.h\""), 0U);
  EXPECT_EQ(complaints("ui/calibration/wand/a.h", "\"ui/calibration/b.h\""), 0U);
  EXPECT_EQ(complaints("ui/calibration/manual/a.h", "\"ui/calibration/points/b.h\""), 0U);
  EXPECT_EQ(complaints("ui/session/a.h", "\"ui/document/b.h\""), 0U);
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
  const std::string path = "core/base/a.h";
  EXPECT_TRUE(violations(path, emptyFile(path) + lines(kLineLimit - 1)).empty());
  EXPECT_EQ(violations(path, emptyFile(path) + lines(kLineLimit)).size(), 1U);
}

TEST(SourceRules, AFileOpensTheNamespaceOfItsFolder) {
  const auto inside = [](const std::string& path, const std::string& name) {
    return violations(path, "namespace " + name + " {\nstruct Verdict {};\n}\n").size();
  };
  EXPECT_EQ(inside("core/calibration/quality/verdict.h", "dewpoint::calibration"), 0U);
  EXPECT_EQ(inside("core/experiment/scenarios/verdict.h", "dewpoint::experiment::scenarios"), 0U);
  EXPECT_EQ(inside("ui/calibration/wand/verdict.h", "dewpoint::ui"), 0U);
  EXPECT_EQ(inside("app/dewpoint-cli/common/verdict.h", "dewpoint::app"), 0U);
  EXPECT_EQ(inside("bench/verdict.h", "bench"), 0U) << "each is a program by itself";

  EXPECT_EQ(inside("core/calibration/quality/verdict.h", "dewpoint"), 1U);
  EXPECT_EQ(inside("core/calibration/quality/verdict.h", "dewpoint::experiment"), 1U);
  EXPECT_EQ(inside("core/camera_motion/verdict.h", "dewpoint::camera"), 1U);
  EXPECT_EQ(inside("core/experiment/suite/verdict.h", "dewpoint::experiments"), 1U);
  EXPECT_EQ(inside("ui/calibration/wand/verdict.h", "dewpoint::calibration"), 1U);
  EXPECT_EQ(inside("app/wiring/verdict.h", "dewpoint::wiring"), 1U);

  EXPECT_TRUE(violations("core/precompiled.h", "#include <vector>\n").empty());
  EXPECT_EQ(violations("core/base/precompiled.h", "#include <vector>\n").size(), 1U);
}

} // namespace
} // namespace dewpoint::tests

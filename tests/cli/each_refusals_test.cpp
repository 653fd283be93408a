// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// What generate --each refuses before any work: one line that says where and what, status 2, no file.

#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

#include "workshop.hpp"

namespace sweepkit::test {
namespace {

struct Case {
  std::string name;
  std::string table;
  std::string message;  ///< after "sweepkit: "
  std::string pattern = "{row}.glb";
  std::vector<std::string> more;
};

std::ostream& operator<<(std::ostream& stream, const Case& c) {
  return stream << c.message;
}

class EachRefuses : public testing::TestWithParam<Case> {};

TEST_P(EachRefuses, InOneLineAndMakesNoFile) {
  const Case& c = GetParam();
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  workshop.write("values.csv", c.table);
  std::filesystem::create_directory(workshop.folder() / "a");
  const auto before = workshop.contents();
  std::vector<std::string> arguments = {"generate", "scene.json", "--each", "values.csv"};
  if (!c.pattern.empty()) arguments.insert(arguments.end(), {"-o", c.pattern});
  arguments.insert(arguments.end(), c.more.begin(), c.more.end());
  const Outcome run = workshop.sweepkit(arguments);
  EXPECT_EQ(run.err, "sweepkit: " + c.message + "\n");
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(workshop.contents(), before);
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

const std::string kGood = "/objects/0/name,/objects/0/scale\na,1\nb,2\n";

INSTANTIATE_TEST_SUITE_P(
    Tables, EachRefuses,
    testing::Values(
        Case{"Empty", "",
             "values.csv: is empty; needs a row of JSON pointers, then a row of values for each file"},
        Case{"NoRows", "/objects/0/name\n",
             "values.csv: has no row of values below its header; add one for each file"},
        Case{"NoPointer", "/objects/0/name,\na,1\n",
             "values.csv:1:17: column 2 needs a JSON pointer above it, such as /objects/0/name"},
        Case{"APointerTwice", "/objects/0/name,/objects/0/name\na,b\n",
             "values.csv:1:17: the pointer /objects/0/name stands above column 1 too; leave one out"},
        Case{"Ragged", "/objects/0/name,/objects/0/scale\na,1\nb,[1,2,3]\n",
             "values.csv:3:1: has 4 cells where the header has 2; put a cell that holds a comma in quotes, "
             "and leave a "
             "cell empty for the scene's value"},
        Case{"AQuoteAstray", "/objects/0/name\n\"a\"b\n",
             "values.csv:2:1: a quote stands astray in this cell; put the whole cell in quotes and double "
             "the quotes "
             "inside"},
        Case{"AWordForAPointer", "name\na\n",
             "values.csv:1:1: a pointer begins with \"/\" (/objects/0/name), got \"name\""},
        Case{"APointerToNowhere", "/objects/0/scale,/objects/7/name\n1,a\n",
             "values.csv:1:18: /objects/7/name: there is no entry \"7\": /objects has the entries 0 to 0; "
             "append with "
             "\"-\""},
        Case{"AMisspeltKey", "/objects/0/scale,/objects/0/nmae\n1,\n1,a\n",
             "values.csv:1:18: /objects/0/nmae: unknown key \"nmae\"; did you mean \"name\"?"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Patterns, EachRefuses,
    testing::Values(
        Case{"OneNameForTwoRows", kGood,
             "-o: one name for 2 rows; put {row} in it, such as out/vase_{row}.glb", "a.glb"},
        Case{"StandardOutput", kGood, "-o: --each makes a file a row; name them, such as out/vase_{row}.glb",
             "-"},
        Case{"UnknownName", kGood,
             "-o: there is no {name}; there is {row}, {/objects/0/name}, {/objects/0/scale}", "{name}.glb"},
        Case{"ABraceThatDoesNotClose", kGood,
             "-o: a brace lacks its other in \"{row.glb\"; with --each a name holds no other braces than "
             "{row} and "
             "{POINTER}",
             "{row.glb"},
        Case{"ABraceThatDoesNotOpen", kGood,
             "-o: a brace lacks its other in \"row}{row}.glb\"; with --each a name holds no other braces "
             "than {row} "
             "and {POINTER}",
             "row}{row}.glb"},
        Case{"AnotherFormat", kGood,
             "{row}.fbx: a model's name ends in .glb, .gltf, .obj, .ply, .stl or .off", "{row}.fbx"},
        Case{"AFormatOfTheRows", kGood,
             "out.{/objects/0/name}: a model's name ends in .glb, .gltf, .obj, .ply, .stl or .off",
             "out.{/objects/0/name}"},
        Case{"TheSameFileTwice", "/objects/0/name,/objects/0/scale\na,1\nb,2\na,3\n",
             "values.csv:4:1: makes the same file as line 2, a.glb; put {row} in -o's name",
             "{/objects/0/name}.glb"},
        Case{"TheSameFileByAnotherWay", "/objects/0/name\na\nb\n",
             "values.csv:3:1: makes the same file as line 2, b/../x.glb; put {row} in -o's name",
             "{/objects/0/name}/../x.glb"},
        Case{"AFolderThatIsNotThere", kGood, "none/1.glb: there is no folder none; make it first",
             "none/{row}.glb"},
        Case{"NoOutput", kGood, "-o FILE is needed (or --explain)", ""}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Options, EachRefuses,
    testing::Values(
        Case{"NoTable",
             kGood,
             "--each: 1 required VALUES.csv missing; see sweepkit generate --help",
             "{row}.glb",
             {"--each"}},
        Case{"NoThreads",
             kGood,
             "--threads: Value 0 not in range 1 to 1024; see sweepkit generate --help",
             "{row}.glb",
             {"--threads", "0"}},
        Case{"ASettingToNowhere",
             kGood,
             "--set: /objects/7/name: there is no entry \"7\": /objects has the entries 0 to 0; append "
             "with \"-\"",
             "{row}.glb",
             {"--set", "/objects/7/name=x"}}),
    name_of);

TEST(EachNeeds, ATableThatIsThere) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  EXPECT_EQ(workshop.sweepkit({"generate", "scene.json", "--each", "none.csv", "-o", "{row}.glb"}).err,
            "sweepkit: none.csv: no such file\n");
  EXPECT_EQ(workshop.sweepkit({"generate", "scene.json", "-o", "a.glb", "--json"}).err,
            "sweepkit: --json: prints tables; add --explain or --each\n");
}

// Names that a cell cannot give: the row is refused, the other is made.
TEST(EachRow, ThatCannotNameItsFileIsRefused) {
  const std::string kName = "/objects/0/name: ";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "is empty, and the file is named for it; give a value, or name files by {row}"},
      {"..", "cannot be part of a file's name: \"..\"; name files by {row}"},
      {".", "cannot be part of a file's name: \".\"; name files by {row}"},
      {"/tmp", "cannot be part of a file's name: \"/tmp\"; name files by {row}"},
      {"\"\"\"/tmp\"\"\"", "cannot be part of a file's name: \"/tmp\"; name files by {row}"},
      {"\"a\tb\"", "cannot be part of a file's name: \"a b\"; name files by {row}"}};
  for (const auto& [cell, problem] : cases) {
    const Workshop workshop;
    workshop.write("scene.json", scene_of(kBall));
    workshop.write("values.csv", "/objects/0/scale,/objects/0/name\n1," + cell + "\n1,good\n");
    const Outcome run =
        workshop.sweepkit({"generate", "scene.json", "--each", "values.csv", "-o", "{/objects/0/name}.glb"});
    EXPECT_EQ(run.err, "sweepkit: values.csv:2:3: /objects/0/name: " + problem +
                           "\nsweepkit: values.csv: 1 row made, 1 refused\n");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(workshop.contents().size(), 3u);
  }
}

TEST(EachRow, WithANameTooLongForTheDiskIsRefused) {
  const Workshop workshop;
  workshop.write("scene.json", scene_of(kBall));
  workshop.write("values.csv", "/objects/0/name\n" + std::string(300, 'n') + "\ngood\n");
  const Outcome run =
      workshop.sweepkit({"generate", "scene.json", "--each", "values.csv", "-o", "{/objects/0/name}.glb"});
  EXPECT_EQ(run.err,
            "sweepkit: values.csv:2:1: makes a file's name of over 240 bytes; shorten it\n"
            "sweepkit: values.csv: 1 row made, 1 refused\n");
}

}  // namespace
}  // namespace sweepkit::test
